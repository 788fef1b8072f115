// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/study_status.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <cmath>
#include <utility>

#include "ui/text/number_text.h"

namespace drillwave {

namespace {

// Before that, the rate is not known.
constexpr double rateSeconds = 0.5;

// Keeps the place of a widget while it is hidden.
void keepPlace(QWidget* widget) {
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
}

}  // namespace

SolveStatus::SolveStatus(QWidget* parent)
    : QWidget(parent), m_text(new QLabel(this)), m_button(new QPushButton(this)) {
    constexpr int leastChars = 12;
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_text->setMinimumWidth(leastChars * fontMetrics().averageCharWidth());
    m_button->setObjectName(QStringLiteral("solveButton"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_button);
    // The line keeps its height when the button appears or goes.
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
    QString text = m_lead.isEmpty() || m_summary.isEmpty() ? m_summary
                                                           : QStringLiteral("%1 · %2").arg(m_lead, m_summary);
    if (m_state == State::stopped)
        text = tr("stopped · the result shown is not that of the present input");
    else if (m_marked)
        text = m_waiting ? tr("solving … %1 waits for the result").arg(m_what) : tr("solving …");
    m_button->setText(m_state == State::stopped ? tr("Solve") : tr("Cancel"));
    m_button->setToolTip(m_state == State::stopped
                             ? tr("Solve the present input")
                             : tr("Stops solving; the old result stays, marked as old"));
    m_button->setVisible(m_marked);
    if (m_line != text) {
        m_line = text;
        m_text->setAccessibleName(text);
        QAccessibleEvent changed(m_text, QAccessible::NameChanged);
        QAccessible::updateAccessibility(&changed);
    }
    layout()->activate();  // the button takes its room first
    elide();
}

void SolveStatus::setLead(const QString& lead) {
    if (std::exchange(m_lead, lead) != lead) tell();
}

void SolveStatus::elide() {
    const QString shown = m_text->fontMetrics().elidedText(m_line, Qt::ElideRight, m_text->width());
    m_text->setText(shown);
    m_text->setToolTip(shown == m_line ? QString() : QStringLiteral("<p>%1</p>").arg(m_line.toHtmlEscaped()));
}

void SolveStatus::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate();
    elide();
}

QString waitText(double seconds, const QLocale& locale) {
    constexpr double mostSeconds = 99;  // as so many, and not as minutes
    const double shown = std::ceil(seconds);
    return shown <= mostSeconds
               ? StudyStatus::tr("%1 s").arg(locale.toString(shown, 'f', 0))
               : StudyStatus::tr("%1 min").arg(locale.toString(std::ceil(shown / 60), 'f', 0));
}

QString progressText(const StudyProgress& progress, double seconds, const QLocale& locale) {
    QString text = QString::number(progress.done);
    if (progress.wanted > 0) text += QLatin1Char('/') + QString::number(progress.wanted);
    if (seconds < rateSeconds || progress.done == 0) return text;
    // No time left is known for a study that takes longer than estimated.
    if (progress.wanted > 0 && progress.done >= progress.wanted) return text;
    const double rate = double(progress.done) / seconds;
    const auto left = double(progress.wanted) - double(progress.done);
    return text + QStringLiteral(" · ") +
           (progress.wanted > 0 ? StudyStatus::tr("%1 left").arg(waitText(left / rate, locale))
                                : StudyStatus::tr("%1/s").arg(numberText(rate, 2, locale)));
}

QString resumeText(const StudyProgress& progress, double seconds, const QLocale& locale) {
    if (seconds < rateSeconds || progress.done == 0 || progress.done >= progress.wanted)
        return StudyStatus::tr("Solve all");
    const double all = seconds / double(progress.done) * double(progress.wanted);
    return StudyStatus::tr("Solve all (%1)").arg(waitText(all, locale));
}

StudyStatus::StudyStatus(QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_bar(new QProgressBar(this)),
      m_text(new QLabel(this)),
      m_button(new QPushButton(this)) {
    m_bar->setTextVisible(false);
    m_bar->setFixedSize(6 * fontMetrics().averageCharWidth() + 24, fontMetrics().height());
    m_bar->setAccessibleName(tr("Progress of the study"));
    constexpr double manySeconds = 99 * 60;
    m_text->setMinimumWidth(m_text->fontMetrics().horizontalAdvance(
        QStringLiteral("9999/9999 · ") + tr("%1 left").arg(waitText(manySeconds, locale()))));
    m_button->setObjectName(QStringLiteral("studyButton"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    for (QWidget* part : {static_cast<QWidget*>(m_title), static_cast<QWidget*>(m_bar),
                          static_cast<QWidget*>(m_text), static_cast<QWidget*>(m_button)}) {
        layout->addWidget(part);
        keepPlace(part);
    }
    m_late.setSingleShot(true);
    m_late.setInterval(usualPatience);
    connect(&m_late, &QTimer::timeout, this, &StudyStatus::showRunning);
    connect(m_button, &QPushButton::clicked, this, [this] {
        if (!m_activity) return;
        if (m_activity->state() == StudyState::stopped)
            m_activity->resume();
        else
            m_activity->cancel();
    });
    clear();
}

void StudyStatus::follow(StudyActivity* activity, const QString& name) {
    if (m_activity) disconnect(m_activity, nullptr, this, nullptr);
    m_activity = activity;
    m_name = name;
    m_late.stop();
    m_since.invalidate();
    clear();
    if (!activity) return;
    connect(activity, &StudyActivity::changed, this, &StudyStatus::update);
    if (activity->state() == StudyState::running || activity->state() == StudyState::stopped) update();
}

void StudyStatus::update() {
    if (m_activity->state() == StudyState::running) {
        if (!m_since.isValid()) clear();  // the message of a stopped one
        // A study that has done nothing has just begun.
        if (!m_since.isValid() || m_activity->progress().done == 0) m_since.start();
        if (m_button->isHidden()) {
            if (!m_late.isActive()) m_late.start();
        } else {
            showRunning();
        }
        return;
    }
    const double seconds = m_since.isValid() ? double(m_since.elapsed()) / 1000 : 0;
    m_late.stop();
    m_since.invalidate();
    clear();
    if (m_activity->state() == StudyState::stopped) showStopped(seconds);
}

void StudyStatus::showStopped(double seconds) {
    m_text->setText(progressText(m_activity->progress(), 0, locale()));
    setButton(resumeText(m_activity->progress(), seconds, locale()),
              tr("Runs the study again to its end, whatever time it takes"));
    const QString limit = locale().toString(qint64(unaskedTime.count()));
    if (m_activity->isOutOfTime())
        setTitle(tr("%1 stopped after %2 s").arg(m_name, limit), tr("stopped after %1 s").arg(limit));
    else
        setTitle(tr("%1 stopped").arg(m_name), tr("stopped"));
}

void StudyStatus::setButton(const QString& words, const QString& toolTip) {
    m_button->setText(words);
    m_button->setToolTip(toolTip);
    m_button->show();
    show();
}

void StudyStatus::showRunning() {
    if (!m_activity || m_activity->state() != StudyState::running) return;
    const StudyProgress progress = m_activity->progress();
    m_text->setText(progressText(progress, double(m_since.elapsed()) / 1000, locale()));
    m_bar->setVisible(progress.wanted > 0);
    if (progress.wanted > 0) m_bar->setValue(int(100.0 * double(progress.done) / double(progress.wanted)));
    setButton(tr("Cancel"), tr("Stops the study; the points found so far stay"));
    setTitle(m_name, {});
}

// The page on show has that name: where there is no room, it is the part that can be done without.
void StudyStatus::setTitle(const QString& title, const QString& shortTitle) {
    m_title->setText(title);
    if (!fitsItsLine()) m_title->setText(shortTitle);
}

bool StudyStatus::fitsItsLine() const {
    if (!parentWidget()) return true;
    int needed = 0;
    for (const QWidget* part : parentWidget()->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
        constexpr int betweenParts = 6;
        if (part == this || part->isVisible()) needed += part->sizeHint().width() + betweenParts;
    }
    return needed <= parentWidget()->width();
}

void StudyStatus::clear() {
    m_title->clear();
    m_text->clear();
    m_bar->hide();
    m_button->hide();
    hide();
}

QString StudyStatus::text() const {
    return QStringLiteral("%1 %2").arg(m_title->text(), m_text->text()).trimmed();
}

}  // namespace drillwave
