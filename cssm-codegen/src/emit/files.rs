//! The files of a case, by target: names and bytes.

use cssm_core::table::{CaseTable, Shader};

use crate::Generated;

/// What a case can be emitted as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Target {
    /// One WGSL file for each shader.
    Wgsl,
    /// One SPIR-V file for each shader with entry points.
    Spirv,
    /// One Rust module.
    Rust,
    /// One JSON file.
    Json,
}

impl Target {
    /// Every target.
    pub const ALL: [Self; 4] = [Self::Wgsl, Self::Spirv, Self::Rust, Self::Json];

    /// Name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Wgsl => "wgsl",
            Self::Spirv => "spirv",
            Self::Rust => "rust",
            Self::Json => "json",
        }
    }
}

/// A file to write.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GeneratedFile {
    /// File name without a folder, such as `sun.mask.wgsl`.
    pub name: String,
    /// What it is.
    pub target: Target,
    /// Contents.
    pub bytes: Vec<u8>,
}

impl Generated {
    /// The files of the case for some targets, in the order of [`Target::ALL`].
    pub fn files(&self, targets: &[Target]) -> Vec<GeneratedFile> {
        let table = &self.table;
        let mut files = Vec::new();
        for target in Target::ALL.into_iter().filter(|target| targets.contains(target)) {
            let mut push = |name: String, bytes: Vec<u8>| files.push(GeneratedFile { name, target, bytes });
            match target {
                Target::Wgsl => {
                    for shader in table.shaders.iter() {
                        push(shader_name(table, shader, "wgsl"), shader.wgsl.as_bytes().to_vec());
                    }
                }
                Target::Spirv => {
                    for shader in table.shaders.iter().filter(|shader| !shader.spirv.is_empty()) {
                        push(shader_name(table, shader, "spv"), shader.spirv.to_vec());
                    }
                }
                Target::Rust => push(format!("{}.rs", table.prefix), self.rust.clone().into_bytes()),
                Target::Json => push(format!("{}.json", table.prefix), self.json.clone().into_bytes()),
            }
        }
        files
    }
}

/// Name of a shader's file.
pub(crate) fn shader_name(table: &CaseTable, shader: &Shader, extension: &str) -> String {
    format!("{}.{}.{extension}", table.prefix, shader.kind.name())
}
