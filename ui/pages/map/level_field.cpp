// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/map/level_field.h"

#include "core/text/units.h"
#include "ui/text/typed_text.h"

namespace drillwave {

LevelField::LevelField(QWidget* parent) : QLineEdit(parent) {
    setObjectName(QStringLiteral("levels"));
    setAccessibleName(tr("Contours at"));
    setPlaceholderText(tr("none"));
    setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0.4; 0.5; 0.6; 0.7")) + 16);
    setMaximumWidth(2 * minimumWidth());
    presentProblem();
    connect(this, &QLineEdit::editingFinished, this, &LevelField::read);
}

void LevelField::setLevels(const std::vector<double>& levels) {
    m_levels = levels;
    QStringList texts;
    for (const double level : levels)
        texts << localText(QString::fromStdString(formatNumber(level)), locale());
    setText(texts.join(QStringLiteral("; ")));
    m_problem.clear();
    presentProblem();
}

void LevelField::read() {
    std::vector<double> levels;
    m_problem.clear();
    for (const QString& item : text().split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
        if (item.trimmed().isEmpty()) continue;
        const PlainText plain = plainText(item.trimmed(), locale());
        const std::optional<double> level = parseNumber(plain.text.toStdString());
        if (!plain.problem.isEmpty())
            m_problem = plain.problem;
        else if (!level)
            m_problem = tr("%1 is not a number").arg(item.trimmed());
        if (!m_problem.isEmpty()) break;
        levels.push_back(*level);
    }
    if (levels.size() > mostLevels) m_problem = tr("at most %1 levels").arg(mostLevels);
    presentProblem();
    if (!m_problem.isEmpty() || levels == m_levels) return;
    m_levels = levels;
    emit changed();
}

void LevelField::presentProblem() {
    setToolTip(m_problem.isEmpty() ? tr("Values of the contours, in the present units: 0.95; 1; 1.05")
                                   : QStringLiteral("⚠ ") + m_problem);
    setStyleSheet(m_problem.isEmpty() ? QString()
                                      : QStringLiteral("QLineEdit { border: 2px solid #c62828; }"));
}

}  // namespace drillwave
