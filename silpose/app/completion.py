"""The script by which a shell completes commands, runs, and choices of groups."""

from __future__ import annotations

from collections.abc import Sequence

from silpose.app.conf_folder import groups

_OF_RUNS = ("open", "compare", "picture", "film", "repair")  # commands that are given runs

_SCRIPT = r"""
_silpose() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} group=
    if [[ $word == = ]]; then
        group=$before word=
    elif [[ $before == = ]]; then
        group=${COMP_WORDS[COMP_CWORD-2]}
    fi
    case $group in
CHOICES
    '') ;;
    *) return ;;
    esac
    case ${COMP_WORDS[1]} in
    RUNS) COMPREPLY=($(compgen -G "recordings/*/*/" | sed 's:/$::')) ;;
    serve|list) return ;;
    settings) COMPREPLY=(GROUPS) ;;
    *)
        [[ $COMP_CWORD == 1 ]] && COMPREPLY=(VERBS)
        COMPREPLY+=(EQUALS)
        ;;
    esac
    COMPREPLY=($(compgen -W "${COMPREPLY[*]}" -- "$word"))
    [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2> /dev/null
}
complete -o bashdefault -o default -F _silpose silpose  # else by the names of files
"""


def completion_script(shell: str, verbs: Sequence[str], tools: Sequence[str]) -> str:
    """Write the script that a shell reads when it starts.

    Parameters
    ----------
    shell : {"bash", "zsh"}
    verbs, tools : sequence of str
        Commands that are given a path, and the others.
    """
    choices = "\n".join(
        f"""    {group}) COMPREPLY=($(compgen -W "{" ".join(names)}" -- "$word")); return ;;"""
        for group, names in groups().items()
    )
    parts = {
        "CHOICES": choices,
        "RUNS": "|".join(_OF_RUNS),
        "GROUPS": " ".join(groups()),
        "VERBS": " ".join((*verbs, *tools)),
        "EQUALS": " ".join(f"{group}=" for group in groups()),
    }
    script = _SCRIPT
    for name, text in parts.items():
        script = script.replace(name, text)
    if shell == "zsh":
        script = "autoload -U +X compinit bashcompinit && compinit && bashcompinit\n" + script
    return script.strip()
