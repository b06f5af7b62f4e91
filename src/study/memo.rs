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
        if let Some(value) = self.last().filter(|_| self.has(&key)) {
            return value;
        }
        let value = Arc::new(compute());
        self.version += 1;
        self.last = Some((key, Arc::clone(&value)));
        value
    }

    /// Whether the last value is that for `key`.
    pub fn has(&self, key: &K) -> bool {
        self.last.as_ref().is_some_and(|(last, _)| last == key)
    }

    /// The last value, whatever it was for.
    #[must_use]
    pub fn last(&self) -> Option<Arc<V>> {
        let (_, value) = self.last.as_ref()?;
        Some(Arc::clone(value))
    }

    /// A number that grows by 1 with each computation.
    #[must_use]
    pub fn version(&self) -> u64 {
        self.version
    }
}

/// A computed value as a part of a key: equal to itself alone, so that it need not be compared.
#[derive(Debug)]
pub struct Same<T>(pub Arc<T>);

impl<T> Clone for Same<T> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<T> PartialEq for Same<T> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
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

    #[test]
    fn a_value_is_the_same_as_itself_alone() {
        let one = Arc::new(1);
        assert!(Same(Arc::clone(&one)) == Same(one));
        assert!(Same(Arc::new(1)) != Same(Arc::new(1)));
    }
}
