//! The tree of a JSON file as serde reads it: every fault gets the place of its key or value.

use super::json::{Fault, one_of};
use super::scanner::{quoted, shown};
use jsonc_parser::ast::{Object, ObjectProp, Value};
use jsonc_parser::common::Ranged;
use serde::de::value::StrDeserializer;
use serde::de::{
    DeserializeSeed, Deserializer, Error as _, Expected, IntoDeserializer, MapAccess, SeqAccess,
    Visitor,
};
use serde_spanned::de::{SpannedDeserializer, is_spanned};
use std::collections::HashSet;
use std::fmt;
use std::ops::Range;

/// A value of the tree, for serde.
#[derive(Clone, Copy)]
pub(super) struct Node<'n> {
    /// The whole file.
    pub text: &'n str,
    pub value: &'n Value<'n>,
}

impl<'n> Node<'n> {
    fn start(self) -> usize {
        self.value.range().start
    }

    fn span(self) -> Range<usize> {
        let range = self.value.range();
        range.start..range.end
    }

    /// Reads the value; a fault without a place of its own is here.
    ///
    /// # Errors
    /// If it is not as the seed wants it.
    pub fn read<'de, S: DeserializeSeed<'de>>(self, seed: S) -> Result<S::Value, Fault> {
        let read = seed.deserialize(self);
        read.map_err(|fault| fault.or_at(self.start()))
    }

    fn wrong(self, expected: &dyn fmt::Display) -> Fault {
        let found = match self.value {
            Value::StringLit(string) => quoted(&string.value),
            Value::NumberLit(number) => shown(number.value),
            Value::BooleanLit(boolean) => boolean.value.to_string(),
            Value::NullKeyword(_) => "null".to_owned(),
            Value::Array(_) => "a list".to_owned(),
            Value::Object(_) => "an object".to_owned(),
        };
        Fault::at(self.start(), format!("expected {expected}, found {found}"))
    }

    /// The number here, as a `T`.
    fn number<T: std::str::FromStr>(self, expected: &str) -> Result<T, Fault> {
        let number = self.value.as_number_lit();
        let number = number.and_then(|number| number.value.parse().ok());
        number.ok_or_else(|| self.wrong(&expected))
    }

    /// The text of a string.
    fn string(self, expected: &dyn fmt::Display) -> Result<&'n str, Fault> {
        let string = self.value.as_string_lit();
        let string = string.ok_or_else(|| self.wrong(expected))?;
        check_string(self.text, self.span())?;
        Ok(&string.value)
    }

    fn fields(self, expected: &dyn fmt::Display) -> Result<Fields<'n>, Fault> {
        let object = self.value.as_object();
        Fields::new(self.text, object.ok_or_else(|| self.wrong(expected))?)
    }

    fn items(self, expected: &dyn fmt::Display) -> Result<Items<'n>, Fault> {
        let list = self.value.as_array().ok_or_else(|| self.wrong(expected))?;
        Ok(Items {
            text: self.text,
            left: list.elements.iter(),
        })
    }
}

/// Refuses line ends and other control characters in a string, as the standard does and the
/// parser does not.
fn check_string(text: &str, span: Range<usize>) -> Result<(), Fault> {
    let control = |byte: &u8| *byte < b' ';
    match text.as_bytes()[span.clone()].iter().position(control) {
        None => Ok(()),
        Some(at) => Err(Fault::at(
            span.start + at,
            "expected an escape such as \\n, found a control character in a string",
        )),
    }
}

impl<'de> Deserializer<'de> for Node<'_> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            Value::StringLit(_) => visitor.visit_str(self.string(&"a string")?),
            Value::NumberLit(_) => visitor.visit_f64(self.number("a number")?),
            Value::BooleanLit(boolean) => visitor.visit_bool(boolean.value),
            Value::NullKeyword(_) => visitor.visit_unit(),
            Value::Array(_) => visitor.visit_seq(self.items(&"a list")?),
            Value::Object(_) => visitor.visit_map(self.fields(&"an object")?),
        }
    }

    fn deserialize_f32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let number: f32 = self.number("a number")?;
        if number.is_finite() {
            visitor.visit_f32(number)
        } else {
            let message = "expected a number below 3.4e38, found a larger one";
            Err(Fault::custom(message))
        }
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_f64(self.number("a number")?)
    }

    fn deserialize_u32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_u32(self.number("a whole number from 0")?)
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let boolean = self.value.as_boolean_lit();
        visitor.visit_bool(boolean.ok_or_else(|| self.wrong(&"true or false"))?.value)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_str(self.string(&"a string")?)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.deserialize_str(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            Value::NullKeyword(_) => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_seq(self.items(&"a list")?)
    }

    fn deserialize_tuple<V: Visitor<'de>>(
        self,
        _length: usize,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let items = self.items(&(&visitor as &dyn Expected))?;
        visitor.visit_seq(items)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let fields = self.fields(&(&visitor as &dyn Expected))?;
        visitor.visit_map(fields)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        if is_spanned(name) {
            visitor.visit_map(SpannedDeserializer::new(self, self.span()))
        } else {
            visitor.visit_map(self.fields(&"an object")?)
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let name = self.string(&one_of(variants))?;
        visitor.visit_enum(StrDeserializer::new(name))
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_unit()
    }

    serde::forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u8 u16 u64 u128 char bytes byte_buf unit unit_struct tuple_struct
        identifier
    }
}

impl<'de> IntoDeserializer<'de, Fault> for Node<'_> {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

/// The values of a list.
struct Items<'n> {
    text: &'n str,
    left: std::slice::Iter<'n, Value<'n>>,
}

impl<'de> SeqAccess<'de> for Items<'_> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Fault> {
        let text = self.text;
        let next = self.left.next();
        next.map(|value| Node { text, value }.read(seed))
            .transpose()
    }
}

/// The keys and values of an object.
struct Fields<'n> {
    text: &'n str,
    left: std::slice::Iter<'n, ObjectProp<'n>>,
    value: Option<&'n Value<'n>>,
}

impl<'n> Fields<'n> {
    /// # Errors
    /// At the first key that is there again.
    fn new(text: &'n str, object: &'n Object<'n>) -> Result<Self, Fault> {
        let mut seen = HashSet::with_capacity(object.properties.len());
        for property in &object.properties {
            let name = property.name.as_str();
            if !seen.insert(name) {
                let message = format!("expected each name once, found {} again", quoted(name));
                return Err(Fault::at(property.name.range().start, message));
            }
        }
        Ok(Self {
            text,
            left: object.properties.iter(),
            value: None,
        })
    }
}

impl<'de> MapAccess<'de> for Fields<'_> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Fault> {
        let Some(property) = self.left.next() else {
            return Ok(None);
        };
        self.value = Some(&property.value);
        let range = property.name.range();
        check_string(self.text, range.start..range.end)?;
        let key = Key {
            text: property.name.as_str(),
            span: range.start..range.end,
        };
        let read = seed.deserialize(key);
        read.map(Some).map_err(|fault| fault.or_at(range.start))
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Fault> {
        let value = self.value.take();
        let value = value.ok_or_else(|| Fault::custom("expected a key before its value"))?;
        let text = self.text;
        Node { text, value }.read(seed)
    }
}

/// The key of an object.
struct Key<'n> {
    text: &'n str,
    span: Range<usize>,
}

impl<'de> Deserializer<'de> for Key<'_> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_str(self.text)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        if is_spanned(name) {
            visitor.visit_map(SpannedDeserializer::new(self.text, self.span))
        } else {
            self.deserialize_any(visitor)
        }
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option
        unit unit_struct newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}
