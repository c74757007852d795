"""What every command shares with the shell it is called from: Blender started ahead, errors in a sentence or as JSON,
and a quiet exit when the reader of the output closes the pipe.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer
from typer.core import TyperGroup
from typer.exceptions import TyperException

from storyblender.errors import InputError, StoryBlenderError
from storyblender.terminal import Terminal

if TYPE_CHECKING:
    from storyblender.engine.worker import Worker

CLOSED_PIPE = 141
"""Exit code after a closed pipe: 128 plus the number of SIGPIPE, as shells report it."""
_NEED_BLENDER = ("render", "edit", "instruct", "check", "export")
"""Commands on finished projects that Blender answers."""


class Commands(TyperGroup):
    """The group of all commands.

    Starts Blender before the words are even read: reading them takes a quarter of the time that it needs.
    """

    def main(
        self,
        args: Sequence[str] | None = None,
        prog_name: str | None = None,
        complete_var: str | None = None,
        standalone_mode: bool = True,
        windows_expand_args: bool = True,
        **extra: Any,
    ) -> Any:
        """Run a command and exit; what was mistyped is refused like every other input.

        Args:
            args: Words after the name of the program; None takes those that the process was started with.
            prog_name: Name of the program in the help; None finds it out.
            complete_var: Environment variable that asks for completion; None derives it from the name.
            standalone_mode: Not used: it always exits.
            windows_expand_args: Whether to expand ``*`` in the words on Windows.
            extra: For click's context.

        Raises:
            SystemExit: Always, with the exit code.
        """
        words = sys.argv[1:] if args is None else args
        _open_closed_streams()
        try:
            try:
                code = super().main(args, prog_name, complete_var, False, windows_expand_args, **extra)
            except TyperException as error:
                Terminal(quiet=True, json_lines="--json" in words).error(_mistyped(error))
                code = 2
            sys.stdout.flush()
        except (BrokenPipeError, SystemExit) as error:  # rich and typer answer a closed pipe with an exit of their own
            if not isinstance(error, BrokenPipeError) and not isinstance(error.__context__, BrokenPipeError):
                raise
            _hush()
            sys.exit(CLOSED_PIPE)
        sys.exit(code or 0)

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Start Blender if the words ask for it, then read them.

        Args:
            ctx: Click's context; its ``obj`` becomes the Blender worker, or None.
            args: Words after the name of the program.

        Returns:
            The words that are left for the command.
        """
        ctx.obj = ahead = _started_for(args)
        if ahead is not None:
            ctx.call_on_close(ahead.close)
        return super().parse_args(ctx, args)


@contextmanager
def shown(quiet: bool, json_lines: bool) -> Iterator[Terminal]:
    """Show what happens; turn the errors we raise on purpose into one sentence and exit code 2.

    Args:
        quiet: Say nothing but errors.
        json_lines: Write events, results and errors as JSON, one a line.
    """
    terminal = Terminal(quiet=quiet, json_lines=json_lines)
    try:
        with terminal:
            yield terminal
    except StoryBlenderError as error:
        terminal.error(error)
        raise typer.Exit(2) from error
    except BrokenPipeError:  # the reader closed the pipe
        raise
    except OSError as error:  # no room, no permission, no such disk: the machine's sentence, and what to do
        mend = "mend that, then run the same command again to go on"
        terminal.error(InputError(error.strerror or str(error), mend=mend, path=error.filename))
        raise typer.Exit(2) from error
    except MemoryError as error:
        mend = "close other programs or give --jobs 1, then run the same command again to go on"
        terminal.error(StoryBlenderError("there is not enough memory", mend=mend))
        raise typer.Exit(2) from error
    except KeyboardInterrupt as error:
        terminal.error(StoryBlenderError("stopped", mend="run the same command again to go on"))
        raise typer.Exit(130) from error


def _mistyped(error: Exception) -> InputError:
    """Return what is wrong with a command line as an error of ours."""
    said = error.format_message() if hasattr(error, "format_message") else str(error)  # type: ignore[attr-defined]
    context = getattr(error, "ctx", None)
    command = context.command_path if context is not None else "storyblender"
    return InputError(said[:1].lower() + said[1:].rstrip("."), mend=f"see `{command} --help`")


def _open_closed_streams() -> None:
    """Let what is said go nowhere where a stream is closed from the start, as a service or ``>&-`` leaves it."""
    if sys.stdout is None:
        sys.stdout = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115 - open as long as the program is
    if sys.stderr is None:
        sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115


def _hush() -> None:
    """Send what is left to say nowhere, so that the interpreter does not complain of the closed pipe at its end."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:
            os.dup2(nowhere, stream.fileno())


def _started_for(words: Sequence[str]) -> Worker | None:
    """Return Blender's worker, coming up, for a command on a finished project; the first word that names one counts."""
    from storyblender.engine.worker import blender_worker
    from storyblender.settings_file import REMEMBERED, SettingsFile

    for word in words[1:] if words and words[0] in _NEED_BLENDER else ():
        try:
            if Path(word, "graph.json").is_file():
                settings = SettingsFile.read(Path(word, REMEMBERED))
                if settings is not None and "build" in settings.values:
                    return None  # whether that folder may be written to is for the command to say
                models = settings.paths("models") if settings and "models" in settings.values else []
                worker = blender_worker(Path(word), models if isinstance(models, list) else [models])
                worker.start()
                return worker
        except (OSError, StoryBlenderError):  # the command itself will say what is wrong with the folder
            return None
    return None
