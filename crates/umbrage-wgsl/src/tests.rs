//! Every text is valid, and says what the data beside it says.

mod combinations;
mod imports;
mod layout;
mod modules;
