//! A computed value that is kept while its inputs stay the same.

use std::sync::Arc;

/// The last value computed, with the key it was computed from.
#[derive(Debug)]
pub struct Memo<K, V> {
    last: Option<(K, Arc<V>)>,
    version: u64,
}

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Self {
            last: None,
            version: 0,
        }
    }
}

impl<K: PartialEq, V> Memo<K, V> {
    /// The value of `compute` for `key`, computed only where the key differs from the last one.
    pub fn get(&mut self, key: K, compute: impl FnOnce() -> V) -> Arc<V> {
        if let Some((last, value)) = &self.last
            && *last == key
        {
            return Arc::clone(value);
        }
        let value = Arc::new(compute());
        self.version += 1;
        self.last = Some((key, Arc::clone(&value)));
        value
    }

    /// A number that grows by 1 with each computation.
    #[must_use]
    pub fn version(&self) -> u64 {
        self.version
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_key_computes_once() {
        let mut memo = Memo::default();
        assert_eq!(*memo.get(1, || "one"), "one");
        assert_eq!(*memo.get(1, || "again"), "one");
        assert_eq!(memo.version(), 1);
        assert_eq!(*memo.get(2, || "two"), "two");
        assert_eq!(memo.version(), 2);
    }
}
