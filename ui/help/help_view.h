// SPDX-License-Identifier: GPL-3.0-or-later
// A chapter of the manual in a reader: with its links, back and forward, and the words of a search marked.
#pragma once

#include <QTextBrowser>
#include <QTimer>

#include "ui/help/manual_book.h"

namespace drillwave {

/// Shows one place of a book.
class HelpView : public QTextBrowser {
    Q_OBJECT

  public:
    /// The book must outlive the view.
    explicit HelpView(const ManualBook& book, QWidget* parent = nullptr);

    const ManualPlace& place() const { return m_history[m_at].place; }
    /// Goes to a place; the last one stays in the history. Unknown headings lead to the chapter's beginning.
    void go(const ManualPlace& place);
    /// Marks these words wherever they are, and scrolls to the first of them below the place.
    void mark(const QStringList& words);
    /// Lays out the chapter again, for example in other colours; keeps the scroll position.
    void layOut();

    bool hasBackward() const { return m_at > 0; }
    bool hasForward() const { return m_at + 1 < m_history.size(); }
    void backward() override;
    void forward() override;

    /// The size of the type in per cent of that of the window.
    int zoom() const { return m_zoom; }
    void setZoom(int percent);

    QVariant loadResource(int type, const QUrl& name) override;

  signals:
    /// Another place is on show.
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
    QString m_shown;  // the chapter that is laid out
    QStringList m_words;
    int m_zoom = 100;
    qreal m_usualSize;  // of the type [pt]
    QTimer m_laterLayout;
};

}  // namespace drillwave
