// SPDX-License-Identifier: GPL-3.0-or-later
// Strip above the pages for messages that need no answer.
#pragma once

#include <QFrame>

class QHBoxLayout;
class QPushButton;

namespace drillwave {

class ScrolledLabel;

/// Strip above the pages with a message; its last button closes it. It is hidden if the text is empty. The
/// text can be selected, and scrolls if it would take too much room from the pages.
class Notice : public QFrame {
    Q_OBJECT

  public:
    enum class Tone { information, warning };

    explicit Notice(Tone tone, QWidget* parent = nullptr);

    /// Adds a button to the notice, to the left of the one that closes it, and returns it.
    QPushButton* addButton(const QString& text, const QString& toolTip);
    void say(const QString& text);
    /// Changes the message, without showing or hiding the notice.
    void setText(const QString& text);
    QString text() const;

  signals:
    /// Emitted when the user closes the notice.
    void dismissed();

  private:
    QHBoxLayout* m_layout;
    ScrolledLabel* m_text = nullptr;
};

}  // namespace drillwave
