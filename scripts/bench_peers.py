"""The measurement of scripts/bench-peers, which installs Mitsuba and starts this.

Timed, for both programs: one operation of one material, in f32, on arrays in memory, all its results written to memory.
Times are in nanoseconds per pair of directions.

Mitsuba (variant llvm_ad_rgb) traces calls into one kernel, compiles it once and launches it on the arrays. The main
number is the execution time of that kernel from Dr.Jit's kernel history: it leaves out the tracing, the compilation and
the look-up of the compiled kernel, which would be paid once for larger arrays. The wall clock around dr.eval and
dr.sync_thread, with the look-up, stands beside it. Each repetition traces anew; that it is one kernel, and that none is
compiled, is checked. Directions, random numbers and the materials' parameters are arguments of the kernel, not
constants in it, and nothing carries gradients. The methods are called on the BSDF itself, not through a table of BSDFs.

Ours measures itself: the verb `bench`, its dispatched path on one thread, its parallel path on two. Dr.Jit asks the
system for huge pages for its arrays; ours gets them too, by a setting of the C library's allocator.
"""

import argparse
import csv
import io
import json
import os
import platform
import re
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path
from statistics import median

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")

PAIRS = 1 << 20
SEED = 1
WARM_UPS = 5
REPETITIONS = 31
# Pairs whose values are compared.
CHECKED = 200
# The number of threads, and our path on it.
PATHS = {1: "dispatched", 2: "parallel"}
# Mitsuba's operations and ours.
OPERATIONS = {"eval": "f", "pdf": "pdf", "sample": "sample_f"}
# The load of the machine (mean of the last minute) above which the numbers are doubtful.
QUIET = 0.3

GGX = {"type": "roughconductor", "distribution": "ggx", "sample_visible": True}
GOLD = {
    "eta": {"type": "rgb", "value": [0.143, 0.375, 1.442]},
    "k": {"type": "rgb", "value": [3.983, 2.386, 1.603]},
}
# Our text of each material, and Mitsuba's description. Mitsuba's masking is the separable one.
MATERIALS = {
    "lambertian_reflection:reflectance=.8/.5/.2": {
        "type": "diffuse",
        "reflectance": {"type": "rgb", "value": [0.8, 0.5, 0.2]},
    },
    "rough_conductor:eta=.2,k=3.9,alpha=.3,masking=separable": GGX | {"eta": 0.2, "k": 3.9, "alpha": 0.3},
    "rough_conductor:masking=separable,alpha=.3": GGX | GOLD | {"alpha": 0.3},
    "rough_conductor:masking=separable,alpha_x=.1,alpha_y=.5": GGX | GOLD | {"alpha_u": 0.1, "alpha_v": 0.5},
    "rough_conductor:masking=separable,distribution=beckmann,alpha=.3": GGX
    | GOLD
    | {"distribution": "beckmann", "alpha": 0.3},
    "rough_dielectric:masking=separable,alpha=.3,eta=1.5": {
        "type": "roughdielectric",
        "distribution": "ggx",
        "alpha": 0.3,
        "int_ior": 1.5,
        "ext_ior": 1.0,
    },
    "principled": {
        "type": "principled",
        "base_color": {"type": "rgb", "value": [0.82, 0.67, 0.16]},
        "roughness": 0.5,
        "specular": 0.5,
        "metallic": 0.0,
        "spec_trans": 0.0,
        "clearcoat": 0.0,
        "sheen": 0.0,
    },
}


def wanted(description, operation):
    """How many times as fast as Mitsuba we want to be."""
    if description["type"] == "diffuse":
        return 0.8
    if description.get("distribution") == "ggx" and description["type"] == "roughconductor" and operation != "pdf":
        return 1.2
    return 1.0


class Pairs:
    """Random pairs of directions and random numbers: wo above the surface, wi above it or on both sides."""

    def __init__(self, both_sides, folder):
        generator = np.random.default_rng(SEED)
        # 1 - random() is never 0: no direction lies in the surface.
        wo = self.directions(generator, 1 - generator.random(PAIRS))
        height = 1 - generator.random(PAIRS)
        wi = self.directions(generator, 2 * height - 1 if both_sides else height)
        # Nine arrays, one after the other: wo_x, wo_y, wo_z, wi_x, wi_y, wi_z, uc, u0, u1.
        self.arrays = np.concatenate([wo, wi, generator.random((3, PAIRS), dtype=np.float32)]).astype("<f4")
        self.file = folder / ("sphere.f32" if both_sides else "hemisphere.f32")
        self.arrays.tofile(self.file)

        # Mitsuba's wi is our wo: the direction to the viewer.
        self.interaction = dr.zeros(mi.SurfaceInteraction3f, PAIRS)
        self.interaction.wi = mi.Vector3f(self.arrays[0:3])
        self.light = mi.Vector3f(self.arrays[3:6])
        self.choice = mi.Float(self.arrays[6])
        self.point = mi.Point2f(self.arrays[7:9])
        dr.make_opaque(self.interaction, self.light, self.choice, self.point)

    @staticmethod
    def directions(generator, z):
        phi, r = 2 * np.pi * generator.random(PAIRS), np.sqrt(1 - z * z)
        return np.stack([r * np.cos(phi), r * np.sin(phi), z])


def mitsuba_results(bsdf, operation, pairs):
    """The components of the results of an operation, not yet computed."""
    context = mi.BSDFContext()
    if operation == "eval":
        return list(bsdf.eval(context, pairs.interaction, pairs.light))
    if operation == "pdf":
        return [bsdf.pdf(context, pairs.interaction, pairs.light)]
    sample, weight = bsdf.sample(context, pairs.interaction, pairs.choice, pairs.point)
    return [*sample.wo, sample.pdf, *weight]


def quartiles(seconds):
    first, middle, third = np.percentile(np.array(seconds) * 1e9 / PAIRS, [25, 50, 75])
    return {"ns": float(middle), "spread": [float(first), float(third)]}


@contextmanager
def thread_per_core(threads):
    """Gives Mitsuba its threads, the worker on another core than the calling thread, which counts as one.

    Left to itself, the system may wake the worker on the core of the caller, and two threads are as slow as one.
    """
    dr.set_thread_count(threads)
    allowed = os.sched_getaffinity(0)
    first = min(allowed)
    if threads > 1:
        for task in map(int, os.listdir("/proc/self/task")):
            os.sched_setaffinity(task, {first} if task == os.getpid() else allowed - {first} or allowed)
    try:
        yield
    finally:
        # Our program would inherit the one core.
        for task in map(int, os.listdir("/proc/self/task")):
            os.sched_setaffinity(task, allowed)


def time_mitsuba(bsdf, pairs):
    """Per operation: the kernel's time, the wall clock's, and what is known of the kernel."""
    timings = {}
    for operation in OPERATIONS:
        kernel_seconds, wall_seconds = [], []
        for repetition in range(WARM_UPS + REPETITIONS):
            results = mitsuba_results(bsdf, operation, pairs)
            dr.sync_thread()
            dr.kernel_history_clear()
            start = time.perf_counter()
            dr.eval(results)
            dr.sync_thread()
            wall = time.perf_counter() - start
            launches = dr.kernel_history()
            if repetition < WARM_UPS:
                continue
            if len(launches) != 1 or not launches[0]["cache_hit"]:
                sys.exit(f"error: Mitsuba's {operation} is not one compiled kernel: {launches}")
            kernel_seconds.append(launches[0]["execution_time"] / 1e3)
            wall_seconds.append(wall)
        timings[operation] = quartiles(kernel_seconds) | {
            "wall": quartiles(wall_seconds),
            "vector_width": int(re.search(r"<(\d+) x float>", launches[0]["ir"].getvalue())[1]),
            # Components that are equal by construction are computed and written once.
            "arrays_written": len({component.index for component in results}),
        }
    return timings


def run_ours(binary, *arguments, stdin=None):
    environment = os.environ | {"GLIBC_TUNABLES": "glibc.malloc.hugetlb=1"}
    done = subprocess.run([binary, *arguments], input=stdin, capture_output=True, text=True, env=environment)
    if done.returncode != 0:
        sys.exit(f"error: {binary} {' '.join(map(str, arguments))} failed:\n{done.stderr.strip()}")
    return done.stdout


def time_ours(binary, material, pairs, threads):
    """Per operation (by Mitsuba's names) our time, and what is said of the machine."""
    only = ("--precision", "f32", "--path", PATHS[threads], "--threads", str(threads))
    report = json.loads(run_ours(binary, "bench", material, "--pairs", pairs.file, *only, "--json"))
    rows = {row["operation"]: {"ns": row["ns"], "spread": row["spread"]} for row in report["rows"]}
    missing = OPERATIONS.values() - rows.keys()
    if missing:
        sys.exit(f"error: {binary} bench gives no {', '.join(missing)} in f32, {PATHS[threads]}, for {material}")
    about = {"ours": {key: report[key] for key in ("machine", "instruction_set")}}
    return {theirs: rows[ours] for theirs, ours in OPERATIONS.items()}, about


def compare_values(binary, material, bsdf, pairs):
    """The largest relative differences of f and pdf, ours in f64 from Mitsuba's in f32."""
    chosen = np.linspace(0, PAIRS - 1, CHECKED).astype(int)
    directions = pairs.arrays[0:6, chosen].T.astype(float)
    lines = [",".join(map(repr, row)) for row in directions.tolist()]
    table = run_ours(binary, "eval", material, stdin="wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n" + "\n".join(lines))
    rows = list(csv.DictReader(io.StringIO(table)))
    columns = {name: np.array([float(row[name]) for row in rows]) for name in ("f_r", "f_g", "f_b", "pdf")}
    # Mitsuba's value includes the cosine.
    cosine = abs(directions[:, 5])
    ours = {"f": np.stack([columns[name] * cosine for name in ("f_r", "f_g", "f_b")]), "pdf": columns["pdf"]}
    theirs = {
        "f": np.stack([np.array(c)[chosen] for c in mitsuba_results(bsdf, "eval", pairs)]),
        "pdf": np.array(mitsuba_results(bsdf, "pdf", pairs)[0])[chosen],
    }
    difference = {}
    for name in ours:
        # Values a millionth of the largest or smaller count as noise.
        scale = np.maximum(abs(ours[name]), abs(ours[name]).max() * 1e-6)
        difference[name] = float((abs(theirs[name] - ours[name]) / scale).max())
    return difference


def over_rounds(measurements):
    """Medians of the rounds' medians and quartiles."""
    merged = {"ns": median(m["ns"] for m in measurements)}
    merged["spread"] = [median(m["spread"][i] for m in measurements) for i in (0, 1)]
    return merged


def print_table(header, rows, markdown):
    cells = [header, *rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(header))]
    # Numbers to the right.
    lines = [
        [cell.rjust(width) if re.match(r"\d", cell) else cell.ljust(width) for cell, width in zip(row, widths)]
        for row in cells
    ]
    if markdown:
        lines.insert(1, ["-" * width for width in widths])
    for line in lines:
        print("| " + " | ".join(line) + " |" if markdown else "  ".join(line).rstrip())
    print()


def machine():
    """The processor's name."""
    try:
        return re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())[1]
    except (OSError, TypeError):
        return platform.processor() or platform.machine()


def main():
    parser = argparse.ArgumentParser(prog="bench-peers", add_help=False)
    parser.add_argument("binary", nargs="?", type=os.path.abspath)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--markdown", action="store_true")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--mitsuba-only", action="store_true")
    options = parser.parse_args()
    if options.rounds < 1:
        parser.error("--rounds must be at least 1")
    if options.binary is None and not options.mitsuba_only:
        parser.error("which explorer is to be measured?")
    if options.binary and not os.access(options.binary, os.X_OK):
        parser.error(f"{options.binary} is no program")

    load = os.getloadavg()[0]
    llvm = ".".join(map(str, dr.detail.llvm_version()))
    about = {"machine": machine(), "cores": os.cpu_count(), "load_before": load, "pairs": PAIRS, "seed": SEED}
    about |= {"rounds": options.rounds, "mitsuba": mi.__version__, "drjit": dr.__version__, "llvm": llvm}
    dr.set_flag(dr.JitFlag.KernelHistory, True)
    bsdfs = {material: mi.load_dict(description) for material, description in MATERIALS.items()}

    with tempfile.TemporaryDirectory() as folder:
        hemisphere, sphere = (Pairs(both_sides, Path(folder)) for both_sides in (False, True))
        pairs = {m: sphere if d["type"] == "roughdielectric" else hemisphere for m, d in MATERIALS.items()}
        differences = {}
        if options.binary:
            differences = {m: compare_values(options.binary, m, bsdfs[m], pairs[m]) for m in MATERIALS}

        # The programs take turns, and go first in turns: both meet the same moods of the machine.
        times = {"mitsuba": {}, "ours": {}}
        for turn in range(options.rounds):
            for threads in PATHS:
                for material in MATERIALS:
                    for program in ("ours", "mitsuba") if turn % 2 == 0 else ("mitsuba", "ours"):
                        if program == "mitsuba":
                            with thread_per_core(threads):
                                timings = time_mitsuba(bsdfs[material], pairs[material])
                        elif options.mitsuba_only:
                            continue
                        else:
                            timings, said = time_ours(options.binary, material, pairs[material], threads)
                            about |= said
                        for operation, timing in timings.items():
                            times[program].setdefault((material, operation, threads), []).append(timing)

    rows = []
    for (material, operation, threads), measured in times["mitsuba"].items():
        row = {"material": material, "operation": operation, "threads": threads, "mitsuba": over_rounds(measured)}
        row["mitsuba"]["wall"] = over_rounds([m["wall"] for m in measured])
        row["mitsuba"] |= {key: measured[0][key] for key in ("vector_width", "arrays_written")}
        if (material, operation, threads) in times["ours"]:
            row["ours"] = over_rounds(times["ours"][material, operation, threads])
            row["ratio"] = row["mitsuba"]["ns"] / row["ours"]["ns"]
            row["wanted"] = wanted(MATERIALS[material], operation)
            row["met"] = row["ratio"] >= row["wanted"]
        rows.append(row)

    if options.json:
        report = about | {"rows": rows, "value_differences": differences}
        options.json.write_text(json.dumps(report, indent=2) + "\n")

    width = rows[0]["mitsuba"]["vector_width"]
    print(f"{about['machine']}, {about['cores']} cores; {PAIRS} pairs, {options.rounds} rounds")
    print(f"Mitsuba {mi.__version__}, Dr.Jit {dr.__version__}, LLVM {llvm}, {width} pairs per vector", end="")
    print(f"; ours: {about['ours']['instruction_set']}" if "ours" in about else "")
    quiet = "quiet" if load <= QUIET else "not quiet: the numbers are doubtful"
    print(f"Load of the machine before: {load:.2f} ({quiet})\n")

    header = ["material", "operation", "threads", "Mitsuba ns", "quartiles", "wall", "ours ns", "quartiles", "ratio"]
    header += ["wanted", "met"]
    table = []
    for row in rows:
        cells = [row["material"], row["operation"], str(row["threads"])]
        for program in ("mitsuba", "ours"):
            if program in row:
                cells += [f"{row[program]['ns']:.2f}", "{:.2f} to {:.2f}".format(*row[program]["spread"])]
            if program == "mitsuba":
                cells.append(f"{row['mitsuba']['wall']['ns']:.2f}")
        if "ours" in row:
            cells += [f"{row['ratio']:.2f}", f"{row['wanted']:.1f}", "yes" if row["met"] else "NO"]
        table.append(cells)
    print_table(header[: len(table[0])], table, options.markdown)
    print("ns: per pair, median of the rounds' medians. wall: Mitsuba's wall clock, with the look-up of the kernel.")
    print("ratio: Mitsuba / ours; above 1, ours is faster.")
    print("Mitsuba computes and writes equal components once (arrays_written in the JSON file).\n")

    if differences:
        cells = [[m, f"{d['f']:.1e}", f"{d['pdf']:.1e}"] for m, d in differences.items()]
        print_table(["largest relative difference of values", "f", "pdf"], cells, options.markdown)
        print(f"Over {CHECKED} pairs, ours in f64 from Mitsuba in f32. Known to differ: Beckmann, whose masking")
        print("Mitsuba approximates, and principled, where Mitsuba's Fresnel term and choice of lobes are others.")


if __name__ == "__main__":
    main()
