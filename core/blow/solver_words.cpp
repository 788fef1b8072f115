// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/solver_words.h"

#include "core/blow/method.h"
#include "core/model/blow_traits.h"

namespace drillwave {

std::string_view methodKey(const Scenario& scenario, Method method) {
    return isFollowedByEvents(scenario) ? name(method) : methodOfStrings;
}

SolverWords solverWords(const Blow& blow) {
    const std::string key(methodKey(blow.scenario, blow.method.method));
    const std::string count = std::to_string(blow.impact.pieces);
    if (!isFollowedByEvents(blow.scenario)) {
        const Message cells = translatable("polynomial cells");
        return {key, cells, cells, "method " + key, {translatable("%1 cells"), {count}}};
    }
    const MethodChoice& choice = blow.method;
    const std::string remark = describe(choice);
    const Message word = nameMessage(choice.method), asked = methodMessage(choice);
    if (choice.method != Method::lattice)
        return {key, word, asked, remark, {translatable("%1 pieces"), {count}}};
    return {key,
            {translatable("%1 of %2 segments"), {word, std::to_string(choice.lattice.segments)}},
            asked,
            remark,
            {translatable("%1 steps"), {count}}};
}

}  // namespace drillwave
