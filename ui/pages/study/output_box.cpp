// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/output_box.h"

#include <QSignalBlocker>

#include "core/report/output_words.h"

#include "ui/text/shown_text.h"

namespace drillwave {

OutputBox::OutputBox(QWidget* parent, OfferedOutputs offered) : ChoiceBox(parent), m_offered(offered) {
    setObjectName(QStringLiteral("output"));
    setAccessibleName(tr("Result"));
    setToolTip(tr("Which result is shown"));
    connect(this, &QComboBox::currentIndexChanged, this, [this] {
        m_isChosen = true;
        if (currentData().toString() == std::exchange(m_shown, currentData().toString())) return;
        emit changed();
    });
}

void OutputBox::present(const Scenario& scenario) {
    // The first output follows the scenario; a choice of the user does not.
    const QString first = findOutput("efficiency_error")->concerns(scenario) ? QStringLiteral("efficiency")
                                                                             : QStringLiteral("cor");
    const QString before = m_isChosen ? m_shown : first;
    {
        const QSignalBlocker quiet(this);
        clear();
        for (const Output& output : outputs()) {
            if (!output.problem(scenario).isEmpty()) continue;
            if (m_offered == OfferedOutputs::ofOneBlow && output.needsThrustStudy()) continue;
            addItem(outputName(output), fromView(output.name));
            setItemData(count() - 1, coreText(output.meaning), Qt::ToolTipRole);
        }
        m_isChosen = m_isChosen && findData(before) >= 0;
        setCurrentIndex(std::max(0, findData(findData(before) < 0 ? first : before)));
    }
    updateGeometry();  // of another text
    if (currentData().toString() != std::exchange(m_shown, currentData().toString())) emit changed();
}

const Output& OutputBox::output() const {
    const Output* found = findOutput(m_shown.toStdString());
    return found ? *found : outputs().front();
}

void OutputBox::setOutput(const Output& output) {
    setCurrentIndex(findData(fromView(output.name)));
    m_isChosen = true;
}

QString outputName(const Output& output) {
    return translated(outputMessage(output));
}

}  // namespace drillwave
