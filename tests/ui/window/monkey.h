// SPDX-License-Identifier: GPL-3.0-or-later
// A monkey at the window: presses, types, drags, drops, opens and saves what it can reach, in any order.
#pragma once

#include <QObject>
#include <QRandomGenerator>
#include <QStringList>
#include <array>

#include "tests/support/scripted_questions.h"
#include "tests/ui/window/monkey_files.h"

namespace drillwave {

/// Every act is one event, or one gesture of a few, at the window as the platform would deliver it. The same
/// seed gives the same acts on the same window.
class Monkey : public QObject {
    Q_OBJECT

  public:
    /// `answers` are what the window's questions get; `files` are what it opens, drops and saves over.
    Monkey(quint32 seed, ScriptedAnswers& answers, MonkeyFiles& files);

    /// Does one thing to the window and lets it take effect.
    void act(QWidget& window);

    /// The last acts in words, the oldest first.
    QStringList record() const;
    /// Whether acts are also printed before they are done.
    void setTalkative(bool talkative) { m_talkative = talkative; }
    /// A modal dialog or an endless loop of events that blocks the monkey; empty while all is well.
    QString stuck() const { return m_stuck; }

  private:
    void pressKey(QWidget& window);
    void typeText(QWidget& window);
    void click(QWidget& window);
    void drag(QWidget& window);
    void turnWheel(QWidget& window);
    void choosePage(QWidget& window);
    void triggerAction(QWidget& window);
    void undoOrRedo(QWidget& window);
    void drop(QWidget& window);
    void resize(QWidget& window);
    void changeColours(QWidget& window);
    void changeFont(QWidget& window);
    void changeFiles(QWidget& window);
    void loseActivation(QWidget& window);

    void prepareAnswers();
    void watchNestedLoop(long act, int tries);
    void leaveNestedLoop();
    void note(const QString& act);
    int upTo(int bound) { return m_random.bounded(bound); }
    bool oneIn(int chances) { return upTo(chances) == 0; }
    template <typename List>
    const auto& any(const List& list) {
        return list[upTo(static_cast<int>(std::size(list)))];
    }
    /// A visible widget that meets the condition; nullptr when there is none.
    QWidget* anyWidget(QWidget& window, bool (*condition)(const QWidget*));
    QPoint anyPoint(const QWidget& widget);
    Qt::KeyboardModifiers anyModifiers();
    Qt::MouseButton anyButton();

    QRandomGenerator m_random;
    QRandomGenerator m_nestedRandom;  // for open menus: how often depends on the clock
    ScriptedAnswers& m_answers;
    MonkeyFiles& m_files;
    std::array<QString, 60> m_record;
    long m_acts = 0;
    bool m_acting = false;
    bool m_talkative = false;
    QString m_stuck;
};

}  // namespace drillwave
