// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace ellipsoid::post {

/// Threads that work off tasks in the order in which they come.
class WorkerPool {
 public:
  explicit WorkerPool(unsigned threads) {
    for (unsigned k = 0; k < threads; ++k)
      m_threads.emplace_back([this] { work(); });
  }
  /// Waits for all tasks.
  ~WorkerPool() {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_closed = true;
    }
    m_has_task.notify_all();
    for (std::thread& thread : m_threads)
      thread.join();
  }
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// The result (or the exception) of a task, when it is done.
  template <class Result> std::future<Result> submit(std::function<Result()> task) {
    auto packaged = std::make_shared<std::packaged_task<Result()>>(std::move(task));
    std::future<Result> result = packaged->get_future();
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_tasks.emplace_back([packaged] { (*packaged)(); });
    }
    m_has_task.notify_one();
    return result;
  }

 private:
  void work() {
    for (;;) {
      std::function<void()> task;
      {
        std::unique_lock<std::mutex> lock(m_mutex);
        m_has_task.wait(lock, [this] { return m_is_closed || !m_tasks.empty(); });
        if (m_tasks.empty())
          return;
        task = std::move(m_tasks.front());
        m_tasks.pop_front();
      }
      task();
    }
  }

  std::mutex m_mutex;
  std::condition_variable m_has_task;
  std::deque<std::function<void()>> m_tasks;
  bool m_is_closed = false;
  std::vector<std::thread> m_threads;
};

} // namespace ellipsoid::post
