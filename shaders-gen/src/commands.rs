//! What the commands do.

use std::io::Write;

use cssm_codegen::{Generated, Options, Target, dsl, generate_all, write_file};

use crate::Error;
use crate::arguments::{Check, Emit, Explain, Format};
use crate::input::{self, Input};

/// Writes the files of every case.
pub(crate) fn emit(arguments: &Emit, out: &mut dyn Write) -> Result<(), Error> {
    let inputs = input::read(&arguments.files)?;
    let options = Options { crate_path: arguments.crate_path.clone() };
    let targets: Vec<Target> = arguments.target.iter().map(|name| name.target()).collect();
    let files: Vec<_> = generate(&inputs, &options)?.iter().flat_map(|case| case.files(&targets)).collect();

    // Write only now that everything is there.
    let mut written = Vec::new();
    for file in &files {
        let path = arguments.out.join(&file.name);
        let changed = write_file(&path, &file.bytes)?;
        written.push((path.display().to_string(), file.bytes.len(), changed));
    }
    match arguments.format {
        Format::Text => {
            for (path, bytes, changed) in written {
                let verb = if changed { "wrote" } else { "kept " };
                writeln!(out, "{verb} {path}, {bytes} bytes")?;
            }
        }
        Format::Json => {
            let files = written.iter().map(|(path, bytes, changed)| {
                serde_json::json!({ "path": path, "bytes": bytes, "changed": changed })
            });
            writeln!(out, "{:#}", serde_json::json!({ "files": files.collect::<Vec<_>>() }))?;
        }
    }
    Ok(())
}

/// Checks declarations: reads them and generates everything.
pub(crate) fn check(arguments: &Check, out: &mut dyn Write) -> Result<(), Error> {
    let inputs = input::read(&arguments.files)?;
    generate(&inputs, &Options::default())?;
    match arguments.format {
        Format::Text => {
            for input in &inputs {
                let names: Vec<_> = input.cases.iter().map(|case| case.name.as_str()).collect();
                writeln!(out, "{}: ok, {}", input.path.display(), names.join(", "))?;
            }
        }
        Format::Json => {
            let files = inputs.iter().map(|input| {
                let names: Vec<_> = input.cases.iter().map(|case| &case.name).collect();
                serde_json::json!({ "file": input.path.display().to_string(), "cases": names })
            });
            writeln!(out, "{:#}", serde_json::json!({ "files": files.collect::<Vec<_>>() }))?;
        }
    }
    Ok(())
}

/// Says what every case will do and cost; as JSON, the tables themselves.
pub(crate) fn explain(arguments: &Explain, out: &mut dyn Write) -> Result<(), Error> {
    let inputs = input::read(&arguments.files)?;
    let generated = generate(&inputs, &Options::default())?;
    let texts: Vec<_> = match arguments.format {
        Format::Text => generated.into_iter().map(|case| case.explain).collect(),
        Format::Json => generated.into_iter().map(|case| case.json.trim_end().to_owned()).collect(),
    };
    match arguments.format {
        Format::Text => write!(out, "{}", texts.join("\n"))?,
        Format::Json => writeln!(out, "[{}]", texts.join(",\n"))?,
    }
    Ok(())
}

/// Prints the reference of all fields.
pub(crate) fn reference(out: &mut dyn Write) -> Result<(), Error> {
    write!(out, "{}", dsl::reference())?;
    Ok(())
}

fn generate(inputs: &[Input], options: &Options) -> Result<Vec<Generated>, Error> {
    let cases: Vec<_> = inputs.iter().flat_map(|input| input.cases.iter().cloned()).collect();
    Ok(generate_all(&cases, options)?)
}
