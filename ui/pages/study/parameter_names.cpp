// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/parameter_names.h"

#include <QComboBox>
#include <QSignalBlocker>

#include "ui/text/shown_text.h"

namespace drillwave {

QString parameterName(const Parameter& parameter) {
    return (fromView(parameter.label) + QLatin1Char(' ') + shownSymbol(parameter.symbol)).trimmed();
}

void offerParameters(QComboBox& box, const Scenario& scenario) {
    const QSignalBlocker quiet(&box);
    const Parameter* chosen = chosenParameter(box);
    // Parameters, and the separators between them, which have no text.
    for (int i = box.count() - 1; i >= 0; --i)
        if (!box.itemData(i).toString().isEmpty() || box.itemText(i).isEmpty()) box.removeItem(i);
    QString section;
    for (const Parameter& parameter : parameters()) {
        if (!parameter.applies(scenario)) continue;
        if (const QString own = fromView(parameter.section());
            own != std::exchange(section, own) && box.count() > 0)
            box.insertSeparator(box.count());
        box.addItem(parameterName(parameter), fromView(parameter.key));
        box.setItemData(box.count() - 1, fromView(parameter.meaning), Qt::ToolTipRole);
    }
    chooseParameter(box, chosen);
}

const Parameter* chosenParameter(const QComboBox& box) {
    return findParameter(box.currentData().toString().toStdString());
}

void chooseParameter(QComboBox& box, const Parameter* parameter) {
    const QSignalBlocker quiet(&box);
    const int found = parameter ? box.findData(fromView(parameter->key)) : -1;
    box.setCurrentIndex(found >= 0 ? found : 0);
}

}  // namespace drillwave
