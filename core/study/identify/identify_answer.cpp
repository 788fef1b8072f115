// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/identify_answer.h"

#include <algorithm>

namespace drillwave {

std::string_view name(ModelVerdict verdict) {
    switch (verdict) {
        case ModelVerdict::accepted:
            return "accepted";
        case ModelVerdict::strained:
            return "strained";
        case ModelVerdict::rejected:
            break;
    }
    return "rejected";
}

std::string_view name(ParameterVerdict verdict) {
    switch (verdict) {
        case ParameterVerdict::identified:
            return "identified";
        case ParameterVerdict::uncertain:
            return "uncertain";
        case ParameterVerdict::bounded:
            return "bounded";
        case ParameterVerdict::notSeen:
            return "not_seen";
        case ParameterVerdict::rejected:
            break;
    }
    return "rejected";
}

bool RecordAnswer::has(std::string_view remark) const {
    return std::find(remarks.begin(), remarks.end(), remark) != remarks.end();
}

const IdentifiedParameter* RecordAnswer::find(std::string_view key) const {
    for (const IdentifiedParameter& parameter : parameters)
        if (parameter.key == key) return &parameter;
    return nullptr;
}

bool RecordAnswer::saysSomething() const {
    if (refusal || model == ModelVerdict::rejected) return false;
    for (const IdentifiedParameter& parameter : parameters) {
        const bool isMain = parameter.key == "bit_rock.stiffness" || parameter.key == "bit_rock.gamma";
        if (isMain && (parameter.verdict == ParameterVerdict::identified ||
                       parameter.verdict == ParameterVerdict::bounded))
            return true;
    }
    return law == "file";
}

}  // namespace drillwave
