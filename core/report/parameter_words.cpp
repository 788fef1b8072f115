// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/parameter_words.h"

#include <string>
#include <string_view>

#include "core/model/law_parameter.h"
#include "core/model/section_field.h"
#include "core/model/section_words.h"
#include "core/text/printed_text.h"

namespace drillwave {

Message labelMessage(const Parameter& parameter) {
    if (parameter.address) return labelMessage(parameter, addressedWords(*parameter.address, {}));
    if (const std::size_t corner = cornerOf(parameter))
        return {parameter.localKey().ends_with("force") ? translatable("force of corner %1")
                                                        : translatable("slope behind corner %1"),
                {std::to_string(corner)}};
    return Message::ofTable(parameter.label);
}

Message labelMessage(const Parameter& parameter, const Message& section) {
    if (!parameter.address || section.isEmpty()) return labelMessage(parameter);
    return {translatable("%1 of %2"), {Message::ofTable(parameter.address->field->label), section}};
}

Message labelMessage(const Parameter& parameter, const Scenario& scenario) {
    if (!parameter.address) return labelMessage(parameter);
    return labelMessage(parameter, addressedWords(*parameter.address, scenario.drillString));
}

Message titleMessage(const Parameter& parameter, std::string_view symbol) {
    if (symbol.empty()) return labelMessage(parameter);
    return {"%1 %2", {labelMessage(parameter), std::string(symbol)}};
}

Message fieldMessage(const Parameter& parameter, const ReadingStyle& style) {
    if (!style.isPrinted()) return std::string(parameter.key);
    return titleMessage(parameter, printedWords(parameter.symbol));
}

}  // namespace drillwave
