//! The names that shaders and tables of a case carry.

use std::borrow::Cow;

use crate::case::LightCase;

/// Emitted names of a case: `sun_mask_vertex`, `SunFacet`.
pub(in crate::table) struct Names<'a> {
    prefix: &'a str,
}

impl<'a> Names<'a> {
    pub(super) fn of(case: &'a LightCase) -> Self {
        Self { prefix: &case.prefix }
    }

    pub(in crate::table) fn value(&self, name: &str) -> Cow<'static, str> {
        format!("{}_{name}", self.prefix).into()
    }

    pub(super) fn constant(&self, name: &str) -> Cow<'static, str> {
        format!("{}_{name}", self.prefix.to_ascii_uppercase()).into()
    }

    pub(super) fn ty(&self, name: &str) -> Cow<'static, str> {
        let mut camel = String::new();
        for part in self.prefix.split('_') {
            let mut letters = part.chars();
            camel.extend(letters.next().map(|first| first.to_ascii_uppercase()));
            camel.push_str(letters.as_str());
        }
        format!("{camel}{name}").into()
    }
}
