// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QKeySequence>
#include <QScrollArea>
#include <functional>
#include <utility>

#include "widgets/common/scrolled.h"

namespace nmc {

class Requests;

/// A dock whose content is built when it is seen for the first time. Its key shows it, brings it to the front
/// if it is behind another's tab, and closes it if it can be seen.
class LazyDock : public QDockWidget {
    Q_OBJECT

public:
    /// Shows the dock, in front of others in the same place.
    void open();
    [[nodiscard]] bool seen() const { return m_seen; }

signals:
    /// The user has opened the dock, and it may have too little room.
    void roomWanted();
    /// The dock can be seen, and what it shows may be out of date.
    void opened();

protected:
    LazyDock(const QString& objectName, const QString& title, const QKeySequence& key, QWidget* parent);

    /// Builds the content, unless it exists already.
    virtual void build() = 0;

private:
    bool m_seen = false;
    bool m_wasSeen = false;  ///< before the event being handled
};

/// A dock whose content is one page, scrolled if there is little room.
template <typename Page>
class PageDock : public LazyDock {
public:
    PageDock(const QString& objectName, const QString& title, const QKeySequence& key, Requests& requests,
             QWidget* parent)
        : LazyDock(objectName, title, key, parent), m_requests(requests) {}

    /// The content, which is built if necessary.
    Page& page() {
        if (m_page == nullptr) {
            m_page = new Page(m_requests, this);
            showSoFar();
            setWidget(framed());
        }
        return *m_page;
    }
    /// The content, or null until it has been built.
    [[nodiscard]] Page* builtPage() const { return m_page; }
    /// Tells the page something, at once or as soon as it is built; of what it is told before, only the last
    /// counts.
    void tell(std::function<void(Page&)> something) {
        if (m_page != nullptr)
            something(*m_page);
        else
            m_told = std::move(something);
    }

protected:
    /// Shows the page, which is new, what was reported before it was built.
    virtual void showSoFar() {
        if (m_told)
            m_told(*m_page);
    }
    /// What the dock contains: the page, which is new, in a scroll area unless it scrolls by itself.
    [[nodiscard]] virtual QWidget* framed() { return scrolled(m_page); }

    Page* m_page = nullptr;

private:
    void build() override { page(); }

    Requests& m_requests;
    std::function<void(Page&)> m_told;
};

}  // namespace nmc
