#ifndef mpm_granular_core_fetch_h
#define mpm_granular_core_fetch_h

namespace mpm_granular
{
  /// Asks the memory for an object that will be read soon, or written; beyond
  /// the end of an array that is of no effect.
  template <bool to_write = false, class Object>
  inline void
  fetch(const Object *object)
  {
    constexpr unsigned int line  = 64;
    const char            *begin = reinterpret_cast<const char *>(object);
    for (unsigned int i = 0; i < sizeof(Object); i += line)
      __builtin_prefetch(begin + i, to_write);
  }
} // namespace mpm_granular

#endif
