// SPDX-License-Identifier: GPL-3.0-or-later
// Reader for a chapter of the manual, with links, back and forward, and marked search words.
#pragma once

#include <QTextBrowser>
#include <QTimer>

#include "ui/help/manual_book.h"

namespace drillwave {

/// Text view that shows one place of the manual.
class HelpView : public QTextBrowser {
    Q_OBJECT

  public:
    /// Makes a view of the manual `book`, which must outlive it.
    explicit HelpView(const ManualBook& book, QWidget* parent = nullptr);

    const ManualPlace& place() const { return m_history[m_at].place; }
    /// Shows a place and adds it to the history. An unknown heading leads to the start of the chapter.
    void go(const ManualPlace& place);
    /// Marks all occurrences of these words, and scrolls to the first one below the present place.
    void mark(const QStringList& words);
    /// Lays out the chapter again, for example in other colours, without scrolling.
    void layOut();

    bool hasBackward() const { return m_at > 0; }
    bool hasForward() const { return m_at + 1 < m_history.size(); }
    void backward() override;
    void forward() override;

    /// Returns the size of the type, in per cent of that of the window.
    int zoom() const { return m_zoom; }
    void setZoom(int percent);

    QVariant loadResource(int type, const QUrl& name) override;

  signals:
    /// Emitted when the view shows another place of the manual.
    void placeChanged(const drillwave::ManualPlace& place);
    void zoomChanged(int percent);

  protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    struct Visit {
        ManualPlace place;
        int scroll = 0;
    };
    void leave();
    void step(int by);
    void arrive();
    void showChapter();
    void bringUp(const QTextBlock& block);
    void markWords();

    const ManualBook& m_book;
    QList<Visit> m_history{Visit()};
    qsizetype m_at = 0;
    QString m_shown;  // name of the chapter that is laid out
    QStringList m_words;
    int m_zoom = 100;
    qreal m_usualSize;  // size of the type at 100 % zoom [pt]
    QTimer m_laterLayout;
};

}  // namespace drillwave
