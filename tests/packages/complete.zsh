#!/bin/zsh
# tests/packages/complete.zsh -- press TAB behind some words of loft, compare what zsh makes of them
# SPDX-License-Identifier: MIT
# usage: complete.zsh FOLDER ; of _loft
zmodload zsh/zpty
folder=$1
zpty loft zsh -f -i
zpty -w loft "PS1=; fpath=($folder \$fpath); autoload -U compinit; compinit -u -D; \
    setopt no_beep; zstyle ':completion:*' menu no; bindkey '^I' complete-word; \
    show() { print -r -- \"<\$BUFFER>\"; BUFFER=; zle redisplay }; zle -N show; \
    bindkey '^X' show; print READY"
zpty -r -m loft line '*READY*' || exit 1
failed=0
completed() {       # completed WORDS EXPECTED: press TAB, then what stands on the line
    local line
    zpty -w -n loft "$1"$'\t\x18'
    zpty -r -m loft line '*<*>*' || exit 1
    line=${line##*\<}; line=${line%%\>*}
    [[ ${line%% } == $2 ]] || { print -r -- "$1: got '$line', not '$2'"; failed=1; }
}
completed 'loft stre' 'loft stream'
completed 'loft plan --mach' 'loft plan --machine'
completed 'loft stream --plan c' 'loft stream --plan chip'
completed 'loft plot --curvature g' 'loft plot --curvature gauss'
zpty -d loft
exit $failed
