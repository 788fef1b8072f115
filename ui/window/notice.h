// SPDX-License-Identifier: GPL-3.0-or-later
// Strip above the pages for messages that need no answer.
#pragma once

#include <QFrame>

class QHBoxLayout;
class QPushButton;

namespace drillwave {

class ScrolledLabel;

/// Strip with a message, hidden if the text is empty; its last button closes it. The text can be selected,
/// and scrolls if it would take too much room from the pages.
class Notice : public QFrame {
    Q_OBJECT

  public:
    enum class Tone { information, warning };

    explicit Notice(Tone tone, QWidget* parent = nullptr);

    /// Adds a button before the one that closes the strip, and returns it.
    QPushButton* addButton(const QString& text, const QString& toolTip);
    void say(const QString& text);
    /// Changes the text without showing or hiding the strip.
    void setText(const QString& text);
    QString text() const;

  signals:
    /// Emitted when the user closes the strip.
    void dismissed();

  private:
    QHBoxLayout* m_layout;
    ScrolledLabel* m_text = nullptr;
};

}  // namespace drillwave
