#include "engine/distribute/task_queue.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

namespace sigmasweep {
namespace {

using Numbers = std::vector<int>;

wire::Bytes bytes_of(const Numbers& numbers) {
  wire::Bytes bytes;
  for (const int number : numbers) wire::append(bytes, number);
  return bytes;
}

Numbers numbers_in(std::span<const std::byte> bytes) {
  Numbers numbers;
  for (int number = 0; !bytes.empty();) {
    wire::take(bytes, number);
    numbers.push_back(number);
  }
  return numbers;
}

TEST(TaskQueue, GivesHalfFromTheEndRoundedUp) {
  TaskQueue queue(sizeof(int));
  EXPECT_EQ(queue.give_half(), 0u);
  queue.add(bytes_of({1, 2, 3}));
  queue.add(bytes_of({4, 5}));
  EXPECT_EQ(numbers_in(queue.take(1)), Numbers{1});
  EXPECT_FALSE(queue.is_between_chunks());
  EXPECT_EQ(queue.give_half(), 2u);  // of 2, 3, 4, 5
  EXPECT_EQ(numbers_in(queue.first_chunk()), (Numbers{2, 3}));
  EXPECT_EQ(queue.give_half(), 1u);
  EXPECT_EQ(queue.give_half(), 1u);
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.is_between_chunks());
}

TEST(TaskQueue, TakesNoMoreThanAChunkAndPutsBack) {
  TaskQueue queue(sizeof(int));
  queue.add(bytes_of({1, 2, 3}));
  queue.add(bytes_of({4}));
  const wire::Bytes taken = queue.take(99);
  EXPECT_EQ(numbers_in(taken), (Numbers{1, 2, 3}));
  queue.put_back(std::span(taken).subspan(sizeof(int)));
  EXPECT_EQ(numbers_in(queue.take(1)), Numbers{2});
  EXPECT_EQ(numbers_in(queue.take(9)), Numbers{3});
  EXPECT_EQ(numbers_in(queue.take(9)), Numbers{4});
  EXPECT_TRUE(queue.empty());
}

TEST(TaskQueue, RefusesWhatAreNotWholeTasks) {
  TaskQueue queue(sizeof(int));
  EXPECT_THROW(queue.add({}), wire::BadMessage);
  EXPECT_THROW(queue.add(wire::Bytes(5)), wire::BadMessage);
}

/// Each task is taken or given away once, and in order, whatever is done.
TEST(TaskQueue, LosesNothing) {
  std::minstd_rand random(7);
  TaskQueue queue(sizeof(int));
  Numbers expected;  // those in the queue
  for (int step = 0, next = 0; step < 20000; ++step) {
    const auto choice = random() % 4;
    if (choice == 0) {
      Numbers chunk(1 + random() % 9);
      std::iota(chunk.begin(), chunk.end(), next);
      next += static_cast<int>(chunk.size());
      expected.insert(expected.end(), chunk.begin(), chunk.end());
      queue.add(bytes_of(chunk));
    } else if (choice == 1) {
      const std::size_t given = queue.give_half();
      ASSERT_EQ(given, (expected.size() + 1) / 2);
      expected.resize(expected.size() - given);
    } else if (!queue.empty()) {
      const wire::Bytes taken = queue.take(1 + random() % 5);
      const Numbers numbers = numbers_in(taken);
      ASSERT_TRUE(std::equal(numbers.begin(), numbers.end(), expected.begin()));
      const std::size_t done = choice == 2 ? numbers.size() : random() % (numbers.size() + 1);
      queue.put_back(std::span(taken).subspan(done * sizeof(int)));
      expected.erase(expected.begin(), expected.begin() + static_cast<long>(done));
    }
    ASSERT_EQ(queue.empty(), expected.empty());
  }
}

}  // namespace
}  // namespace sigmasweep
