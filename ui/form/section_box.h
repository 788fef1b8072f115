// SPDX-License-Identifier: GPL-3.0-or-later
// Section of a panel with a title, which can be folded.
#pragma once

#include <QScrollArea>
#include <QToolButton>
#include <QWidget>

namespace drillwave {

class SectionBox : public QWidget {
    Q_OBJECT

  public:
    explicit SectionBox(const QString& title, QWidget* parent = nullptr);

    /// Returns the widget that contains the section's content; give it a layout.
    QWidget* content() const { return m_content; }
    QString title() const { return m_header->text(); }
    void setTitle(const QString& title);
    bool isOpen() const { return m_content->isVisibleTo(this); }
    void setOpen(bool open);
    enum class Begin { open, folded };
    /// Opens or folds the section as it was in the last session, by default as `begin` says, and stores its
    /// state from now on. `key` is its key in the settings.
    void rememberAs(const QString& key, Begin begin = Begin::open);

  signals:
    void toggled(bool isOpen);

  private:
    QToolButton* m_header;
    QWidget* m_content;
    QString m_key;
};

// Scroll area whose vertical scroll bar is always visible, so that its width does not change.

/// Scroll area for a column of widgets; it scrolls only vertically and is always as wide as its content.
class SteadyScrollArea : public QScrollArea {
    Q_OBJECT

  public:
    explicit SteadyScrollArea(QWidget* parent = nullptr);

    QSize sizeHint() const override;
    /// Returns a size wide enough to show the full width of the content.
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;

  private:
    QSize around(const QSize& content, int height) const;
};

}  // namespace drillwave
