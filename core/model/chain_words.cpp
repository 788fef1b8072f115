// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/chain_words.h"

#include "core/model/blow_traits.h"
#include "core/text/message.h"

namespace drillwave {

const ChainWords& chainWords(const Scenario& scenario) {
    static constexpr ChainWords ofRod{
        .kind = translatable("uniform rod"),
        .assumptions = translatable("One uniform rod; joints and the mass of the bit are not modelled."),
        .references = translatable("W is the work of the hammer."),
        .errors = translatable("The error bound of e and the errors of the balances are numerical; rock and "
                               "rod are known far less well."),
        .pulse = translatable("pulse %1"),
        .rebound = translatable("The rod rebounds with e = %1."),
        .stresses = translatable("Stress in the rod"),
        .historyPlace = translatable("at the middle of the rod"),
        .blowCaption = translatable("The force N %1 and its waves, the impact force, its impulse and the "
                                    "momentum of the rod over time."),
        .stressCaption = translatable("The largest tension and compression along the rod, during the blow "
                                      "and in the residual waves."),
        .place = translatable("%1 from the struck end"),
        .peakPlace = translatable("%1 from the hammer, %2"),
        .beyondEnd = translatable("place x: must be at most %1, the length of the rod")};
    static constexpr ChainWords ofString{
        .kind = translatable("drill string"),
        .assumptions = translatable("Hammer and string of uniform sections; bending, torsion and friction in "
                                    "threads beyond a loss factor are not modelled."),
        .references = translatable("E₀ and p₀ are the energy and momentum of the hammer."),
        .errors = translatable("The errors of the efficiency and of the balances are numerical; rock and "
                               "string are known far less well."),
        .stresses = translatable("Stress in hammer and string"),
        .historyPlace = translatable("in the middle of the longest section"),
        .blowCaption = translatable("The force N %1 and its waves, the impact force, its impulse and the "
                                    "momentum of the string over time."),
        .stressCaption = translatable("The largest tension and compression along hammer (below 0) and string "
                                      "during the blow, with the strengths of the sections."),
        .place = translatable("%1 from the struck end"),
        .peakPlace = translatable("%1 from the struck end, %2"),
        .beyondEnd = translatable("place x: must be at most %1, the length of the string")};
    static constexpr ChainWords ofForcedString = [] {
        ChainWords words = ofString;
        words.references = translatable("W and E₀ are the work of the force on the string.");
        return words;
    }();
    if (!hasSections(scenario)) return ofRod;
    return isForced(scenario) ? ofForcedString : ofString;
}

}  // namespace drillwave
