#include "ui/alert_list.h"

#include <QLabel>
#include <QVBoxLayout>

namespace drillwave {

AlertList::AlertList(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
}

void AlertList::show(const QString& problem, const std::vector<Alert>& alerts) {
    QStringList texts;
    if (!problem.isEmpty()) texts.append(problem);
    for (const Alert& alert : alerts) texts.append(QString::fromStdString(alert.text));
    // Most solutions while a slider is dragged change nothing here.
    if (texts == m_texts && layout()->count() > 0) return;
    m_texts = texts;
    while (QLayoutItem* item = layout()->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    if (!problem.isEmpty()) add(QStringLiteral("✖"), tr("Not solved"), problem);
    for (const Alert& alert : alerts) {
        const bool warning = alert.level == AlertLevel::warning;
        add(warning ? QStringLiteral("⚠") : QStringLiteral("ℹ"), warning ? tr("Warning") : tr("Note"),
            QString::fromStdString(alert.text));
    }
    if (texts.isEmpty()) add(QStringLiteral("✓"), tr("Nothing unusual"), tr("Nothing unusual."));
}

void AlertList::add(const QString& mark, const QString& kind, const QString& text) {
    auto* label = new QLabel(mark + QLatin1Char(' ') + text, this);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label->setAccessibleName(QStringLiteral("%1: %2").arg(kind, text));
    layout()->addWidget(label);
}

}  // namespace drillwave
