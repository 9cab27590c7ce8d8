//! Every text is valid, and says what the data beside it says.

mod combinations;
mod layout;
mod modules;
