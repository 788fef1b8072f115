// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/alert_link.h"

#include "ui/result/alert_list.h"

namespace drillwave {

AlertLink::AlertLink(const AlertList& list, WithoutAny withoutAny, QWidget* parent)
    : QToolButton(parent), m_list(list), m_withoutAny(withoutAny) {
    setAutoRaise(true);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFocusPolicy(Qt::TabFocus);
    connect(&list, &AlertList::changed, this, &AlertLink::present);
    present();
}

void AlertLink::present() {
    const qsizetype count = m_list.texts().size();
    QString text = tr("✓ nothing unusual");
    if (m_list.hasProblem())
        text = tr("✖ not solved");
    else if (count > 0 && m_list.hasWarnings())
        text = count == 1 ? tr("⚠ 1 alert") : tr("⚠ %1 alerts").arg(count);
    else if (count > 0)
        text = count == 1 ? tr("ℹ 1 note") : tr("ℹ %1 notes").arg(count);
    setText(text);
    QString tip;  // as rich text, which is wrapped
    for (const QString& each : m_list.texts()) tip += QStringLiteral("<p>%1</p>").arg(each.toHtmlEscaped());
    setToolTip(tip);
    setAccessibleDescription(m_list.texts().join(QLatin1Char('\n')));
    if (m_withoutAny == WithoutAny::hidden) setVisible(count > 0);
}

}  // namespace drillwave
