// SPDX-License-Identifier: GPL-3.0-or-later
// A titled part of a panel that can be folded away.
#pragma once

#include <QScrollArea>
#include <QToolButton>
#include <QWidget>

namespace drillwave {

class SectionBox : public QWidget {
    Q_OBJECT

  public:
    explicit SectionBox(const QString& title, QWidget* parent = nullptr);

    /// Where the content goes; give it a layout.
    QWidget* content() const { return m_content; }
    QString title() const { return m_header->text(); }
    void setTitle(const QString& title);
    bool isOpen() const { return m_content->isVisibleTo(this); }
    void setOpen(bool open);
    enum class Begin { open, folded };
    /// Keeps whether it is open under that key of the settings, and is now as it was left.
    void rememberAs(const QString& key, Begin begin = Begin::open);

  signals:
    void toggled(bool isOpen);

  private:
    QToolButton* m_header;
    QWidget* m_content;
    QString m_key;
};

// A column of widgets to be scrolled, always as wide: its scroll bar is there whether it is needed or not.

/// Scrolls vertically only.
class SteadyScrollArea : public QScrollArea {
    Q_OBJECT

  public:
    explicit SteadyScrollArea(QWidget* parent = nullptr);

    QSize sizeHint() const override;
    /// Wide enough that nothing is cut off at the side.
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;

  private:
    QSize around(const QSize& content, int height) const;
};

}  // namespace drillwave
