#ifndef mpm_granular_core_archive_h
#define mpm_granular_core_archive_h

#include <mpm_granular/core/number_type.h>

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace mpm_granular::Core
{
  /**
   * Where the state of objects goes to, and comes back from, when a run is
   * interrupted and continued. An object that has to carry something over has a
   * function serialize(Archive &), which names each of its values once; an
   * archive that writes takes them, one that reads sets them.
   *
   * Names are unique in an archive and of the form "group/name".
   */
  class Archive
  {
  public:
    virtual ~Archive() = default;

    /// Whether values are set.
    virtual bool
    is_reading() const = 0;

    /// Whether the parts of distributed arrays are those that each process had
    /// written: their number has not changed. True when writing.
    virtual bool
    has_same_ranks() const = 0;

    /**
     * A value that is the same on all processes.
     *
     * @param value a number, a std::string, or a std::vector of numbers.
     */
    template <class Value>
    void
    replicated(const std::string &name, Value &value)
    {
      replicate(name, numbers_of(value));
    }

    /**
     * The rows of a table that are on this process; all processes together have
     * the table, in the order of their ranks. All arrays of a group have the
     * same number of rows on a process. Read on another number of processes,
     * each gets about as many rows.
     *
     * @param rows @p width numbers a row.
     */
    template <class Number>
    void
    distributed(const std::string   &name,
                std::vector<Number> &rows,
                const unsigned int   width = 1)
    {
      distribute(name, numbers_of(rows), width);
    }

  protected:
    /// An array of numbers, whatever it is in C++.
    struct Numbers
    {
      NumberType  type;
      std::size_t size;
      const void *data;

      /// Makes place for a number of numbers, always one if is_single.
      /// @return where.
      std::function<void *(const std::size_t)> resize;

      bool is_single;
    };

    virtual void
    replicate(const std::string &name, const Numbers &numbers) = 0;

    virtual void
    distribute(const std::string &name,
               const Numbers     &numbers,
               const unsigned int width) = 0;

  private:
    template <class Value>
    static Numbers
    numbers_of(Value &value)
    {
      if constexpr (std::is_arithmetic_v<Value>)
        return {number_type<Value>(),
                1,
                &value,
                [&value](const std::size_t) { return &value; },
                true};
      else
        return {number_type<typename Value::value_type>(),
                value.size(),
                value.data(),
                [&value](const std::size_t size) {
                  value.resize(size);
                  return value.data();
                },
                false};
    }
  };
} // namespace mpm_granular::Core

#endif
