use super::*;
use crate::error::Error;
use crate::material::file;
use crate::table::{Shape, TABLE};
use crate::{Component, Material};

const DATA: &str = "data";

fn nothing(path: &Path) -> Result<Vec<u8>> {
    panic!("{} is read", path.display());
}

fn table(text: &str, n: usize) -> (Recipe, Table) {
    let material: Material = text.parse().unwrap();
    let shape = Shape::of(n, material.is_isotropic()).unwrap();
    let table = Table::bake(&*material.build::<f64>(), shape, u64::MAX).unwrap();
    (material.recipe(shape).unwrap(), table)
}

fn with(resource: Resource) -> Material {
    let mut component: Component = "table".parse().unwrap();
    component.set_resource(DATA, resource).unwrap();
    Material::from(component)
}

/// What is written of a material, and what is read of that.
fn again(material: &Material) -> (String, Material) {
    let text = file::print(material);
    let read = file::parse(&text, "again.toml").unwrap();
    (text, read)
}

fn data(material: &Material) -> &Resource {
    material.components()[0].params().resource(DATA).unwrap()
}

#[test]
fn what_is_small_stands_in_the_text_and_needs_no_file() {
    let (recipe, table) = table("phong", 4);
    let bytes = table.to_string().into_bytes();
    let decoded = || Arc::new(Decoded::read(bytes.clone(), None, &[&TABLE]).unwrap());
    let baked = with(Resource::baked(recipe, table.clone()));
    let read = with(Resource::read("/f/small.table".into(), decoded()));
    for (material, expected) in [
        (baked, "baked = \"phong\""),
        (read, "file = \"/f/small.table\""),
    ] {
        let (text, mut found) = again(&material);
        assert!(text.contains(expected) && text.contains("sha256"), "{text}");
        found.fetch(&nothing);
        assert!(found.is_complete() && data(&found).problem().is_none());
        assert_eq!(data(&found).origin(), data(&material).origin());
        let value = found.components()[0].params().data::<Table>(DATA).unwrap();
        assert_eq!(*value, table);
    }
}

#[test]
fn what_is_large_is_read_from_its_file_or_baked_again() {
    let (recipe, table) = table("oren_nayar:sigma=35", 24);
    let bytes = table.to_string().into_bytes();
    assert!(bytes.len() as u64 > MAX_INLINE);
    let baked = with(Resource::baked(recipe, table));
    let (text, mut found) = again(&baked);
    assert!(text.len() < 1000, "{text}");
    let line = data(&found).problem().unwrap();
    assert_eq!(
        line,
        "oren_nayar:sigma=35 in a table of 24x24x24 nodes is being baked"
    );
    assert!(!found.is_complete() && found != baked);
    found.fetch(&nothing);
    assert_eq!(found, baked);
    assert!(data(&found).problem().is_none());

    let mut file: Material = "table:data=even.table".parse().unwrap();
    file.rooted_at(Path::new("/f"));
    file.fetch(&|path| {
        assert_eq!(path, Path::new("/f/even.table"));
        Ok(bytes.clone())
    });
    let (_, mut again_here) = again(&file);
    again_here.fetch(&|_| Ok(bytes.clone()));
    assert_eq!(
        again_here.components()[0].params().data::<Table>(DATA),
        file.components()[0].params().data::<Table>(DATA)
    );
    file.relative_to(Path::new("/f"));
    assert!(file::print(&file).contains("file = \"even.table\""));
}

#[test]
fn a_missing_or_changed_file_leaves_a_material_that_says_so() {
    let (_, table) = table("phong", 24);
    let bytes = table.to_string().into_bytes();
    let mut material: Material = "table:data=/f/a.table".parse().unwrap();
    material.fetch(&|_| Ok(bytes.clone()));
    let (_, read) = again(&material);
    for (found, expected) in [
        (
            Err(std::io::ErrorKind::NotFound.into()),
            "/f/a.table is missing: ",
        ),
        (
            Ok(Table::even(0.1).to_string()),
            "/f/a.table has changed since",
        ),
        (
            Ok("name,x\n".to_owned()),
            "/f/a.table is missing: is not HALVES",
        ),
    ] {
        let mut read = read.clone();
        let found: std::result::Result<String, std::io::Error> = found;
        let found = std::cell::RefCell::new(Some(found));
        read.fetch(&|path| {
            let found = found.borrow_mut().take().unwrap();
            found
                .map(String::into_bytes)
                .map_err(|error| Error::io(path, error))
        });
        let line = data(&read).problem().unwrap();
        assert!(line.starts_with(expected) && !line.contains('\n'), "{line}");
        let missing = expected.contains("missing");
        assert_eq!(read.is_complete(), !missing);
        // What it was is written again.
        let hash = Hash::of(&bytes).to_string();
        assert_eq!(file::print(&read).contains(&hash), missing);
        assert_eq!(data(&read).again().content(), &Content::Pending);
    }
}

#[test]
fn embedded_data_has_its_place_in_the_text_whatever_its_size_and_letters() {
    let (recipe, table) = table("phong", 24);
    let mut material = with(Resource::baked(recipe, table));
    material.map_resources(&mut |_, resource| resource.embed());
    // With a line end it is written in base 64.
    let text = table_text_with_line_end();
    let file = Resource::read(
        "a.table".into(),
        Arc::new(Decoded::read(text, None, &[&TABLE]).unwrap()),
    );
    for material in [material, with(file)] {
        let (text, read) = again(&material);
        assert!(read.is_complete());
        assert_eq!(
            read.components()[0].params().data::<Table>(DATA),
            material.components()[0].params().data::<Table>(DATA)
        );
        assert!(
            data(&material).text_bound() + 256 >= text.len() as u64,
            "{text}"
        );
        assert!(data(&read).is_embedded());
    }
}

fn table_text_with_line_end() -> Vec<u8> {
    format!("{}\n", Table::even(0.1)).into_bytes()
}

#[test]
fn broken_data_is_refused_in_a_line() {
    let lobe = |data: &str| format!("[[lobes]]\nmodel = \"table\"\ndata = {data}\n");
    for (value, expected) in [
        ("3", "line 3: data: is no text and no table"),
        ("\"\"", "read is table of values (.table)"),
        ("\"2x2;AAAA\"", "three or four numbers"),
        ("{}", "neither a file nor its bytes"),
        (
            "{ path = \"x\" }",
            "unknown key 'path'; known are file, baked",
        ),
        ("{ file = 3 }", "file is not in quotes"),
        (
            "{ file = \"a\", baked = \"phong\" }",
            "is either a file, or baked",
        ),
        (
            "{ baked = \"phong\" }",
            "is either a file, or baked with a shape",
        ),
        (
            "{ baked = \"phon\", shape = \"2x2x2\" }",
            "unknown model 'phon'",
        ),
        ("{ baked = \"phong\", shape = \"1x2x2\" }", "from 2 to 4096"),
        (
            "{ baked = \"table:data=a.table\", shape = \"2x2x2\" }",
            "has data itself",
        ),
        ("{ file = \"a\", sha256 = \"12\" }", "64 hexadecimal digits"),
        ("{ base64 = \"?\" }", "base64: "),
        ("{ base64 = \"AAAA\", text = \"2x2x2;\" }", "not both"),
    ] {
        let line = file::parse(&lobe(value), "m.toml").unwrap_err().to_string();
        assert!(
            line.contains(expected) && !line.contains('\n'),
            "{value}: {line}"
        );
    }
    let huge = lobe("{ baked = \"phong\", shape = \"4096x4096x4096\" }");
    let mut huge = file::parse(&huge, "m.toml").unwrap();
    huge.fetch(&nothing);
    let line = data(&huge).problem().unwrap();
    assert!(
        line.contains("is missing: the table is of 4096x4096x4096 nodes"),
        "{line}"
    );
}
