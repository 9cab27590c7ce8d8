//! What people should read, until they close it.

/// Messages, oldest first.
#[derive(Clone, Debug, Default)]
pub struct Messages(Vec<String>);

impl Messages {
    /// Shows a message, once however often it is said.
    pub fn say(&mut self, message: impl Into<String>) {
        let message = message.into();
        if !self.0.contains(&message) {
            self.0.push(message);
        }
    }

    /// Shows messages, one after the other.
    pub fn say_all(&mut self, messages: impl IntoIterator<Item = String>) {
        messages.into_iter().for_each(|message| self.say(message));
    }

    /// Returns all of them.
    pub fn all(&self) -> &[String] {
        &self.0
    }

    /// Closes the message of this number.
    pub fn close(&mut self, number: usize) {
        if number < self.0.len() {
            self.0.remove(number);
        }
    }

    /// Closes all of them.
    pub fn close_all(&mut self) {
        self.0.clear();
    }
}
