// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/solver_words.h"

#include "core/blow/method.h"
#include "core/model/blow_traits.h"

namespace drillwave {

SolverWords solverWords(const Blow& blow) {
    if (!isFollowedByEvents(blow.scenario)) {
        const std::string key(methodOfStrings);
        return {key, "polynomial cells", translatable("drillwave::Message", "polynomial cells"),
                "method " + key, "cells"};
    }
    const MethodChoice& choice = blow.method;
    const std::string key(name(choice.method)), remark = describe(choice);
    const Message asked = methodMessage(choice);
    if (choice.method != Method::lattice) return {key, key, asked, remark, "pieces"};
    return {key, key + " of " + std::to_string(choice.lattice.segments) + " segments", asked, remark,
            "steps"};
}

}  // namespace drillwave
