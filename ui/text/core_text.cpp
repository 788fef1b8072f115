// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/core_text.h"

#include <QCoreApplication>
#include <string>

#include "core/model/law_parameter.h"
#include "core/model/section_address.h"
#include "ui/text/shown_text.h"
#include "ui/text/translation.h"

namespace drillwave {
namespace {

QString sectionWords(const SectionAddress& address) {
    const bool ofHammer = address.chain == SectionAddress::Chain::hammer;
    if (address.place > 0) return (ofHammer ? tr("hammer section %1") : tr("section %1")).arg(address.place);
    SectionAddress named = address;
    named.chain = SectionAddress::Chain::string;
    const QString name = QString::fromStdString(named.words());
    return ofHammer ? tr("hammer %1").arg(name) : name;
}

}  // namespace

QString coreText(std::string_view text) {
    return text.empty() ? QString() : QCoreApplication::translate("core", std::string(text).c_str());
}

QString coreName(std::string_view name) {
    return coreText(fromView(name).replace(u'_', u' ').toStdString());
}

QString parameterLabel(const Parameter& parameter) {
    if (parameter.address)
        return tr("%1 of %2")
            .arg(coreText(parameter.address->field->label), sectionWords(*parameter.address));
    if (const std::size_t corner = cornerOf(parameter))
        return (parameter.localKey().ends_with("force") ? tr("force of corner %1")
                                                        : tr("slope behind corner %1"))
            .arg(corner);
    return coreText(parameter.label);
}

QString parameterTitle(const Parameter& parameter) {
    return (parameterLabel(parameter) + QLatin1Char(' ') + shownSymbol(parameter.symbol)).trimmed();
}

}  // namespace drillwave
