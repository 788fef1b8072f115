// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/solve_status.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <utility>

namespace drillwave {

SolveStatus::SolveStatus(QWidget* parent)
    : QWidget(parent), m_text(new QLabel(this)), m_button(new QPushButton(this)) {
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_button->setObjectName(QStringLiteral("solveButton"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->addWidget(m_text);
    layout->addWidget(m_button);
    layout->addStretch();
    // The line keeps its height when the button comes and goes.
    setMinimumHeight(m_button->sizeHint().height());
    m_button->hide();
    m_late.setSingleShot(true);
    m_late.setInterval(usualPatience);
    connect(&m_late, &QTimer::timeout, this, [this] { setMarked(true); });
    connect(m_button, &QPushButton::clicked, this, &SolveStatus::press);
}

void SolveStatus::asked() {
    if (m_state == State::current || m_state == State::quick) m_late.start();
    setState(State::solving);
}

void SolveStatus::answered(const QString& summary) {
    m_summary = summary;
    m_late.stop();
    setState(State::current);
    setMarked(false);
    if (const auto then = std::exchange(m_waiting, {})) then();
}

void SolveStatus::answeredQuickly(const QString& summary) {
    m_summary = summary;
    m_late.stop();
    setState(State::quick);
    setMarked(isWaiting());
}

void SolveStatus::answeredEarlier() {
    if (m_late.isActive()) m_late.start();
}

void SolveStatus::setState(State state) {
    const bool wasCurrent = isCurrent();
    m_state = state;
    tell();
    if (wasCurrent != isCurrent()) emit currentChanged(isCurrent());
}

void SolveStatus::setMarked(bool outOfDate) {
    if (m_marked == outOfDate) return;
    m_marked = outOfDate;
    tell();
    emit marked(outOfDate);
}

void SolveStatus::whenCurrent(const QString& what, std::function<void()> then) {
    if (isCurrent()) return then();
    m_what = what;
    m_waiting = std::move(then);
    m_late.stop();
    if (m_state == State::stopped) emit solveRequested();
    setMarked(true);
    tell();
}

void SolveStatus::callOff(const QString& reason) {
    if (!std::exchange(m_waiting, {})) return;
    tell();
    emit calledOff(tr("%1 was not written: %2").arg(m_what, reason));
}

void SolveStatus::press() {
    if (m_state == State::stopped) return emit solveRequested();
    m_late.stop();
    emit stopRequested();
    setState(State::stopped);
    setMarked(true);
    callOff(tr("solving was cancelled."));
}

void SolveStatus::tell() {
    QString text = m_summary;
    if (m_state == State::stopped)
        text = tr("stopped · what is shown is not of the present input");
    else if (m_marked)
        text = m_waiting ? tr("solving … %1 waits for the result").arg(m_what) : tr("solving …");
    m_button->setText(m_state == State::stopped ? tr("Solve") : tr("Cancel"));
    m_button->setToolTip(m_state == State::stopped
                             ? tr("Solve the present input")
                             : tr("Stop solving; the old result stays, marked as such"));
    m_button->setVisible(m_marked);
    if (m_text->text() == text) return;
    m_text->setText(text);
    QAccessibleEvent changed(m_text, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&changed);
}

}  // namespace drillwave
