// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/core_text.h"

#include <QCoreApplication>
#include <string>

#include "core/report/parameter_words.h"
#include "ui/text/shown_text.h"

namespace drillwave {

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
    return (parameterLabel(parameter) + QLatin1Char(' ') + shownSymbol(parameter.symbol)).trimmed();
}

}  // namespace drillwave
