// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/alert_list.h"

#include <QVBoxLayout>
#include <algorithm>
#include <chrono>

#include "core/model/parameter.h"
#include "core/report/alert_words.h"
#include "core/report/parameter_words.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

// How long a list that has become shorter keeps its room.
constexpr std::chrono::milliseconds shorterListRest{1500};

QString fieldName(const Alert& alert) {
    const KeptParameter parameter = findParameter(alert.parameter);
    return parameter ? translated(labelMessage(*parameter, alert.subject)) : fromView(alert.parameter);
}

}  // namespace

AlertList::AlertList(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    // At the top of the room that is kept, without asking for more.
    layout->setAlignment(Qt::AlignTop);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    m_rest.setSingleShot(true);
    m_rest.setInterval(shorterListRest);
    connect(&m_rest, &QTimer::timeout, this, [this] { setMinimumHeight(0); });
}

void AlertList::present(const QString& problem, const std::vector<Alert>& alerts, const LocalStyle& style) {
    QStringList texts;
    if (!problem.isEmpty()) texts.append(problem);
    for (const Alert& alert : alerts) texts.append(translated(alertMessage(alert, style)));
    // Most solutions while a slider is dragged change nothing here.
    if (texts == m_texts && !m_labels.isEmpty()) return;
    m_texts = texts;
    m_hasProblem = !problem.isEmpty();
    m_warningCount = std::ranges::count(alerts, AlertLevel::warning, &Alert::level);
    if (isVisible()) setMinimumHeight(std::max(minimumHeight(), height()));
    m_rest.start();
    qsizetype row = 0;
    if (!problem.isEmpty()) write(row++, QStringLiteral("✖"), tr("Not solved"), problem);
    for (const Alert& alert : alerts) {
        const bool warning = alert.level == AlertLevel::warning;
        const QString& text = texts[row];
        write(row++, warning ? QStringLiteral("⚠") : QStringLiteral("ℹ"),
              warning ? tr("Warning") : tr("Note"), text, &alert);
    }
    if (row == 0) write(row++, QStringLiteral("✓"), tr("Nothing unusual"), tr("Nothing unusual."));
    for (qsizetype unused = row; unused < m_labels.size(); ++unused) m_labels[unused]->hide();
    emit changed();
}

void AlertList::takeFocus() {
    if (!m_labels.isEmpty()) m_labels.first()->setFocus(Qt::OtherFocusReason);
}

// Labels stay: made anew they would flicker, and take a selection or the focus with them.
QLabel* AlertList::labelAt(qsizetype row) {
    while (m_labels.size() <= row) {
        auto* label = new QLabel(this);
        label->setTextFormat(Qt::RichText);
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextBrowserInteraction | Qt::TextSelectableByKeyboard);
        connect(label, &QLabel::linkActivated, this, &AlertList::parameterChosen);
        static_cast<QVBoxLayout*>(layout())->insertWidget(static_cast<int>(m_labels.size()), label);
        m_labels.append(label);
    }
    return m_labels[row];
}

void AlertList::write(qsizetype row, const QString& mark, const QString& kind, const QString& text,
                      const Alert* alert) {
    QLabel* label = labelAt(row);
    QString html = mark + QLatin1Char(' ') + text.toHtmlEscaped();
    if (alert && !alert->parameter.empty())
        html += QStringLiteral(" <a href=\"%1\">%2</a>")
                    .arg(fromView(alert->parameter).toHtmlEscaped(),
                         tr("Go to “%1”").arg(fieldName(*alert)).toHtmlEscaped());
    if (label->text() != html) label->setText(html);
    label->setAccessibleName(QStringLiteral("%1: %2").arg(kind, text));
    label->setToolTip(kind);
    label->show();
}

AlertLink::AlertLink(const AlertList& list, QWidget* parent) : QToolButton(parent), m_list(list) {
    setAutoRaise(true);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFocusPolicy(Qt::TabFocus);
    connect(&list, &AlertList::changed, this, &AlertLink::present);
    present();
}

void AlertLink::present() {
    const qsizetype count = m_list.texts().size(), warnings = m_list.warningCount(),
                    notes = m_list.noteCount();
    QStringList parts;
    if (m_list.hasProblem()) {
        parts << tr("✖ not solved");
    } else {
        if (warnings > 0) parts << (warnings == 1 ? tr("⚠ 1 warning") : tr("⚠ %1 warnings").arg(warnings));
        if (notes > 0) parts << (notes == 1 ? tr("ℹ 1 note") : tr("ℹ %1 notes").arg(notes));
    }
    setText(parts.join(QStringLiteral(" · ")));
    QString tip;  // as rich text, which is wrapped
    for (const QString& each : m_list.texts()) tip += QStringLiteral("<p>%1</p>").arg(each.toHtmlEscaped());
    setToolTip(tip);
    setAccessibleDescription(m_list.texts().join(QLatin1Char('\n')));
    setVisible(count > 0);
}

}  // namespace drillwave
