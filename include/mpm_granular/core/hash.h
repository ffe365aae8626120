#ifndef mpm_granular_core_hash_h
#define mpm_granular_core_hash_h

#include <cstdint>
#include <cstring>
#include <string>

/*
 * Numbers that tell whether data has changed. They protect against accidents,
 * not against intent. They are the same on every machine, so they may be kept
 * in files.
 */
namespace mpm_granular::Core
{
  /// Spreads every bit of @p bits over all bits of the result (the finaliser of
  /// SplitMix64).
  inline std::uint64_t
  mixed(std::uint64_t bits)
  {
    bits += 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
  }

  /// The hash of two hashes in this order.
  inline std::uint64_t
  combined(const std::uint64_t first, const std::uint64_t second)
  {
    return mixed(first ^ mixed(second));
  }

  /// The hash of a number; 0 and -0 differ.
  inline std::uint64_t
  hash(const double number)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof(bits));
    return mixed(bits);
  }

  /// The hash of a text (FNV-1a).
  inline std::uint64_t
  hash(const std::string &text)
  {
    std::uint64_t result = 0xcbf29ce484222325u;
    for (const char letter : text)
      result = (result ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
    return result;
  }
} // namespace mpm_granular::Core

#endif
