// SPDX-License-Identifier: GPL-3.0-or-later
// Words that name the chain of a scenario: its uniform rod, or hammer and string.
#pragma once

#include "core/model/scenario.h"

namespace drillwave {

/// Sentences and labels about a chain, to be translated by their readers.
struct ChainWords {
    const char* kind;           ///< "uniform rod"
    const char* assumptions;    ///< what the model leaves out, in a sentence or two
    const char* references;     ///< of the shares of energy and momentum in tables
    const char* errors;         ///< what the stated errors are about
    const char* pulse = "";     ///< "pulse %1", behind the groups; empty where they do not describe the blow
    const char* rebound = "";   ///< with e as %1; empty where e is not the main result
    const char* stresses;       ///< title of the largest stresses
    const char* historyPlace;   ///< place of histories where none is chosen
    const char* blowCaption;    ///< of the histories at %1
    const char* stressCaption;  ///< of the largest stresses over the place
    const char* place;          ///< "%1 from the struck end"
    const char* peakPlace;      ///< of a largest stress, with its time as %2
    const char* beyondEnd;      ///< why a place is none, with the length as %1
};
const ChainWords& chainWords(const Scenario& scenario);

}  // namespace drillwave
