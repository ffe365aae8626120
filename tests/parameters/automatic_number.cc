// A number that may be left to the program: what is taken, and what is said of
// it.

#include <mpm_granular/parameters/pattern_text.h>

#include <iostream>

using mpm_granular::Parameters::AutomaticNumber;

int
main()
{
  const AutomaticNumber pattern;
  std::cout << mpm_granular::Parameters::allowed_values(pattern.description())
            << std::endl;
  for (const std::string text :
       {"automatic", "0", "2.5e2", "-1", "100/s", "automatc", ""})
    std::cout << '\'' << text << "': " << pattern.match(text)
              << (pattern.match(text) ? "" :
                                        mpm_granular::Parameters::hint_for(
                                          text, pattern.description(), "1/s"))
              << std::endl;
  std::cout << AutomaticNumber::value_of("automatic", 3.) << ' '
            << AutomaticNumber::value_of("2.5e2", 3.) << std::endl;
}
