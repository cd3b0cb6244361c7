//! Where the fields of a record lie.

use std::borrow::Cow;

use crate::table::{FieldType, Meaning, Record, RecordField, RecordKind};

/// Lays fields out by the uniform address space's rules.
pub(super) struct Layout {
    fields: Vec<RecordField>,
    next: u32,
}

impl Layout {
    pub(super) fn new() -> Self {
        Self { fields: Vec::new(), next: 0 }
    }

    pub(super) fn push(&mut self, name: &str, meaning: Meaning, ty: FieldType) {
        let (size, align) = match ty {
            FieldType::F32 => (4, 4),
            FieldType::Vec2 => (8, 8),
            FieldType::Vec4 => (16, 16),
            // Facets stand in arrays alone, whose stride is given.
            FieldType::Facet => (0, 16),
        };
        let offset_bytes = self.next.next_multiple_of(align);
        self.next = offset_bytes + size;
        let name = name.to_owned().into();
        self.fields.push(RecordField { name, meaning, ty, elements: 0, offset_bytes, stride_bytes: 0 });
    }

    pub(super) fn push_array(
        &mut self,
        name: &str,
        meaning: Meaning,
        ty: FieldType,
        elements: u32,
        stride_bytes: u32,
    ) {
        let offset_bytes = self.next.next_multiple_of(16);
        self.next = offset_bytes + elements * stride_bytes;
        let name = name.to_owned().into();
        self.fields.push(RecordField { name, meaning, ty, elements, offset_bytes, stride_bytes });
    }

    pub(super) fn record(self, kind: RecordKind, name: Cow<'static, str>) -> Record {
        Record { kind, name, size_bytes: self.next.next_multiple_of(16), fields: self.fields.into() }
    }
}
