//! `umbrage settings`: what settings there are, and what each of them does.

use umbrage::schema;

use crate::args::SettingsArgs;
use crate::failure::{Failure, Outcome};
use crate::output::{print, write_text};
use crate::pages;

pub fn run(args: &SettingsArgs) -> Outcome {
    if let Some(path) = &args.json {
        return Ok(write_text(path, &pages::settings::json()?)?);
    }
    let Some(name) = &args.name else {
        let list = || schema::keys().map(|key| format!("{:<36} {}\n", key.name, key.help)).collect();
        let text: String = if args.markdown { pages::settings::markdown()? } else { list() };
        return Ok(print(&text)?);
    };
    let rows: Vec<_> = schema::keys().filter(|key| key.name == name).collect();
    if rows.is_empty() {
        let now = schema::renamed(name)
            .map_or_else(|| "`umbrage settings` lists all".to_owned(), |now| format!("it is now `{now}`"));
        return Err(Failure::usage(format!("there is no setting `{name}`; {now}")));
    }
    for key in rows {
        print(&pages::settings::text(key)?)?;
    }
    Ok(())
}
