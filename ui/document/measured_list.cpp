// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/measured_list.h"

#include <QUndoCommand>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <utility>

#include "ui/document/scenario_edit.h"

namespace drillwave {
namespace {

// Exchanges the signals for others and back; their points are shared, so that nothing is copied.
class MeasuredEdit : public QUndoCommand {
  public:
    MeasuredEdit(std::vector<MeasuredSignal>& current, std::function<void()> changed,
                 std::vector<MeasuredSignal> after, int gesture)
        : m_current(current), m_changed(std::move(changed)), m_other(std::move(after)), m_gesture(gesture) {}

    void undo() override { exchange(); }
    void redo() override { exchange(); }
    int id() const override { return m_gesture == 0 ? -1 : int(UndoKind::measured); }
    // The state before this command stays.
    bool mergeWith(const QUndoCommand* other) override {
        if (static_cast<const MeasuredEdit*>(other)->m_gesture != m_gesture) return false;
        setObsolete(m_other == m_current);
        return true;
    }

  private:
    void exchange() {
        std::swap(m_current, m_other);
        m_changed();
    }

    std::vector<MeasuredSignal>& m_current;
    std::function<void()> m_changed;
    std::vector<MeasuredSignal> m_other;  // those that are not shown
    int m_gesture;
};

}  // namespace

MeasuredList::MeasuredList(QUndoStack& history, QObject* parent) : QObject(parent), m_history(history) {}

void MeasuredList::push(std::vector<MeasuredSignal> after, const QString& step, int gesture) {
    auto* edit = new MeasuredEdit(
        m_signals, [this] { emit changed(); }, std::move(after), gesture);
    edit->setText(step);
    m_history.push(edit);
}

void MeasuredList::add(MeasuredSignal signal) {
    assert(!isFull());
    const std::string name = signal.name;
    const auto isTaken = [this](const std::string& wanted) {
        return std::ranges::find(m_signals, wanted, &MeasuredSignal::name) != m_signals.end();
    };
    for (int i = 2; isTaken(signal.name); ++i) signal.name = name + " (" + std::to_string(i) + ")";
    const QString step = tr("lay over the measured curve %1").arg(QString::fromStdString(signal.name));
    std::vector<MeasuredSignal> after = m_signals;
    after.push_back(std::move(signal));
    push(std::move(after), step);
}

void MeasuredList::remove(std::size_t index) {
    if (index >= m_signals.size()) return;
    const QString name = QString::fromStdString(m_signals[index].name);
    std::vector<MeasuredSignal> after = m_signals;
    after.erase(after.begin() + static_cast<std::ptrdiff_t>(index));
    push(std::move(after), tr("remove the measured curve %1").arg(name));
}

void MeasuredList::setTimeShift(std::size_t index, double seconds, int gesture) {
    if (index >= m_signals.size() || !std::isfinite(seconds)) return;
    if (m_signals[index].timeShift == seconds) return;
    std::vector<MeasuredSignal> after = m_signals;
    after[index].timeShift = seconds;
    push(std::move(after),
         tr("shift the measured curve %1").arg(QString::fromStdString(m_signals[index].name)), gesture);
}

}  // namespace drillwave
