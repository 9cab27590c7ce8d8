//! Why a command failed: the command line was wrong, or the work could not be done.

use std::fmt;
use std::process::ExitCode;

use umbrage_lab::LabError;
use umbrage_render::RenderError;

/// A failed command.
#[derive(Debug)]
pub enum Failure {
    /// A usage error: the command line asks for something that does not exist, or is out of range. Exit status 2.
    Usage(anyhow::Error),
    /// What was asked for could not be done. Exit status 1.
    Work(anyhow::Error),
}

/// What a command returns.
pub type Outcome<T = ()> = Result<T, Failure>;

impl Failure {
    /// A usage error with this message.
    pub fn usage(message: impl fmt::Display + fmt::Debug + Send + Sync + 'static) -> Self {
        Self::Usage(anyhow::Error::msg(message))
    }

    /// The status that scripts see.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::Usage(_) => ExitCode::from(2),
            // A frame that cannot be planned was asked for by flags that passed one by one.
            Self::Work(error) if is_of_plan(error) => ExitCode::from(2),
            Self::Work(_) => ExitCode::from(1),
        }
    }
}

fn is_of_plan(error: &anyhow::Error) -> bool {
    matches!(error.downcast_ref(), Some(RenderError::Plan(_)))
        || matches!(error.downcast_ref(), Some(LabError::Render(RenderError::Plan(_))))
}

impl<E: Into<anyhow::Error>> From<E> for Failure {
    fn from(error: E) -> Self {
        Self::Work(error.into())
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Self::Usage(error) | Self::Work(error)) = self;
        // One line, causes included.
        write!(f, "{}", format!("{error:#}").replace(['\n', '\r'], " "))
    }
}
