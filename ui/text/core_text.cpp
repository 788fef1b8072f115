// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/core_text.h"

#include <QCoreApplication>
#include <string>
#include <utility>

#include "core/report/parameter_words.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

Message titleOf(const Parameter& parameter) {
    return titleMessage(parameter, shownSymbol(parameter.symbol).toStdString());
}

}  // namespace

QString coreText(std::string_view text) {
    return text.empty() ? QString() : QCoreApplication::translate("core", std::string(text).c_str());
}

QString coreName(std::string_view name) {
    return coreText(fromView(name).replace(u'_', u' ').toStdString());
}

QString parameterLabel(const Parameter& parameter) {
    return translated(labelMessage(parameter));
}

QString parameterTitle(const Parameter& parameter) {
    return translated(titleOf(parameter));
}

Message withTitles(Message message) {
    if (message.isWords) {
        const KeptParameter parameter = findParameter(message.pattern);
        return parameter ? titleOf(*parameter) : message;
    }
    for (Message& argument : message.arguments) argument = withTitles(std::move(argument));
    return message;
}

}  // namespace drillwave
