// SPDX-License-Identifier: GPL-3.0-or-later
// A strip above the pages for messages that need no answer.
#pragma once

#include <QFrame>

class QHBoxLayout;
class QPushButton;

namespace drillwave {

class ScrolledLabel;

/// Hidden without a text; its last button closes it. The text can be selected, and scrolls if it would leave
/// the pages too little room.
class Notice : public QFrame {
    Q_OBJECT

  public:
    enum class Tone { information, warning };

    explicit Notice(Tone tone, QWidget* parent = nullptr);

    /// A button in front of the one that dismisses.
    QPushButton* addButton(const QString& text, const QString& toolTip);
    void say(const QString& text);
    /// Changes the text, shown or hidden as it is.
    void setText(const QString& text);
    QString text() const;

  signals:
    /// The user has sent it away.
    void dismissed();

  private:
    QHBoxLayout* m_layout;
    ScrolledLabel* m_text = nullptr;
};

}  // namespace drillwave
