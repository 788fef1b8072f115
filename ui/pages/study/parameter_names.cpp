// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/parameter_names.h"

#include <QComboBox>
#include <QSignalBlocker>

#include "core/model/section_parameter.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

/// "string.coupling", which its numbers stand together under.
QString sectionsOf(const Parameter& parameter) {
    const QString key = fromView(parameter.key);
    return key.left(key.lastIndexOf(QLatin1Char('.')));
}

}  // namespace

QString parameterName(const Parameter& parameter) {
    return parameterTitle(parameter);
}

void offerParameters(QComboBox& box, const Scenario& scenario, StudyOf of) {
    const QSignalBlocker quiet(&box);
    const KeptParameter chosen = chosenParameter(box);
    // Parameters, and the separators between them, which have no text.
    for (int i = box.count() - 1; i >= 0; --i)
        if (!box.itemData(i).toString().isEmpty() || box.itemText(i).isEmpty()) box.removeItem(i);
    QString section;
    const auto offer = [&](const Parameter& parameter, const QString& own) {
        if (own != std::exchange(section, own) && box.count() > 0) box.insertSeparator(box.count());
        box.addItem(parameterName(parameter), fromView(parameter.key));
        box.setItemData(box.count() - 1, coreText(parameter.meaning), Qt::ToolTipRole);
    };
    for (const Parameter& parameter : parameters())
        if (parameter.applies(scenario) && (parameter.scope != Scope::manyBlows || of == StudyOf::manyBlows))
            offer(parameter, fromView(parameter.section()));
    for (const KeptParameter& parameter : variableSectionParameters(scenario))
        offer(*parameter, sectionsOf(*parameter));
    // A number of a section may be asked for by another key than the one that is offered.
    if (chosen && chosen->applies(scenario) && box.findData(fromView(chosen->key)) < 0)
        offer(*chosen, fromView(chosen->section()));
    chooseParameter(box, chosen);
}

KeptParameter chosenParameter(const QComboBox& box) {
    return findParameter(box.currentData().toString().toStdString());
}

void chooseParameter(QComboBox& box, const KeptParameter& parameter) {
    const QSignalBlocker quiet(&box);
    const int found = parameter ? box.findData(fromView(parameter->key)) : -1;
    box.setCurrentIndex(found >= 0 ? found : 0);
    box.updateGeometry();  // of another text
}

}  // namespace drillwave
