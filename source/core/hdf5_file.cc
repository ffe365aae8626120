#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/hdf5_file.h>
#include <mpm_granular/core/synchronize.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

namespace mpm_granular::Core
{
  namespace MPI = dealii::Utilities::MPI;
  namespace fs  = std::filesystem;

  namespace
  {
    bool a_file_is_left = false;



    /// An identifier of HDF5 that is given back at the end of its scope.
    class Handle
    {
    public:
      Handle(const hid_t id, herr_t (*release)(hid_t))
        : id(id)
        , release(release)
      {}

      ~Handle()
      {
        if (is_good())
          release(id);
      }

      Handle(const Handle &) = delete;
      Handle &
      operator=(const Handle &) = delete;

      operator hid_t() const
      {
        return id;
      }

      bool
      is_good() const
      {
        return id >= 0;
      }

    private:
      const hid_t id;
      herr_t (*const release)(hid_t);
    };



    /// The type in memory and, little-endian, in the file. Characters: a string
    /// of @p length.
    hid_t
    copy_of_type(const NumberType    type,
                 const std::uint64_t length,
                 const bool          in_file)
    {
      switch (type)
        {
          case NumberType::natural8:
            return H5Tcopy(in_file ? H5T_STD_U8LE : H5T_NATIVE_UINT8);
          case NumberType::natural32:
            return H5Tcopy(in_file ? H5T_STD_U32LE : H5T_NATIVE_UINT32);
          case NumberType::natural64:
            return H5Tcopy(in_file ? H5T_STD_U64LE : H5T_NATIVE_UINT64);
          case NumberType::real32:
            return H5Tcopy(in_file ? H5T_IEEE_F32LE : H5T_NATIVE_FLOAT);
          case NumberType::real64:
            return H5Tcopy(in_file ? H5T_IEEE_F64LE : H5T_NATIVE_DOUBLE);
          case NumberType::character:
            break;
        }
      const hid_t text = H5Tcopy(H5T_C_S1);
      // Padded, not terminated: the text may have any length and content.
      if (H5Tset_size(text, length) < 0 || H5Tset_strpad(text, H5T_STR_NULLPAD))
        return -1;
      return text;
    }



    /// The number type of a type in a file. @return whether there is one.
    bool
    find_type(const hid_t type, NumberType &result)
    {
      const H5T_class_t kind = H5Tget_class(type);
      const std::size_t size = H5Tget_size(type);
      if (kind == H5T_STRING)
        result = NumberType::character;
      else if (kind == H5T_FLOAT && size == 8)
        result = NumberType::real64;
      else if (kind == H5T_FLOAT && size == 4)
        result = NumberType::real32;
      else if (kind == H5T_INTEGER && size == 8)
        result = NumberType::natural64;
      else if (kind == H5T_INTEGER && size == 4)
        result = NumberType::natural32;
      else if (kind == H5T_INTEGER && size == 1)
        result = NumberType::natural8;
      else
        return false;
      return true;
    }



    /// A space of @p n_rows rows, with one dimension if a row is one number.
    hid_t
    make_space(const std::uint64_t n_rows, const std::uint64_t width)
    {
      const std::array<hsize_t, 2> size{{n_rows, width}};
      return H5Screate_simple(width == 1 ? 1 : 2, size.data(), nullptr);
    }



    /// Properties of the class @p kind for what is made, without the time of its
    /// making: files with the same content are the same.
    hid_t
    creation_properties(const hid_t kind)
    {
      const hid_t properties = H5Pcreate(kind);
      H5Pset_obj_track_times(properties, false);
      return properties;
    }



    /// A text is one row of HDF5's type string, not a row of characters.
    std::uint64_t
    numbers_a_row(const NumberType type, const Extent &extent)
    {
      return type == NumberType::character ? 1 : extent.width;
    }
  } // namespace



  Hdf5File::Hdf5File(const std::string &path,
                     const Mode         mode,
                     const MPI_Comm     comm)
    : comm(comm)
  {
    // What HDF5 would print is said in one message.
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);

    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    // Newer object headers have checksums of their own.
    const bool is_set_up =
      access.is_good() && H5Pset_fapl_mpio(access, comm, MPI_INFO_NULL) >= 0 &&
      H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST) >= 0;
    require_on_all(is_set_up, "open a file in parallel");
    const Handle creation(creation_properties(H5P_FILE_CREATE), H5Pclose);
    file = mode == Mode::create ?
             H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access) :
             H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
    require_on_all(file >= 0, "open the file");
  }



  Hdf5File::~Hdf5File()
  {
    try_to_close();
  }



  bool
  Hdf5File::is_broken()
  {
    return a_file_is_left;
  }



  bool
  Hdf5File::try_to_close()
  {
    const bool is_closed = file < 0 || H5Fclose(file) >= 0;
    a_file_is_left       = a_file_is_left || !is_closed;
    file                 = -1;
    return is_closed;
  }



  void
  Hdf5File::close()
  {
    require_on_all(try_to_close(), "write the file");
  }



  Extent
  Hdf5File::extent(const std::string &name, NumberType &type) const
  {
    const Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    require_on_all(dataset.is_good(), "find '" + name + "'");
    const Handle           file_type(H5Dget_type(dataset), H5Tclose);
    const Handle           space(H5Dget_space(dataset), H5Sclose);
    std::array<hsize_t, 2> size{{1, 1}};
    const int              n_dimensions = H5Sget_simple_extent_ndims(space);
    require_on_all(find_type(file_type, type) && n_dimensions >= 1 &&
                     n_dimensions <= 2 &&
                     H5Sget_simple_extent_dims(space, size.data(), nullptr) >=
                       0,
                   "understand '" + name + "'");
    Extent result;
    result.n_rows = size[0];
    result.width =
      type == NumberType::character ? H5Tget_size(file_type) : size[1];
    return result;
  }



  void
  Hdf5File::write(const std::string &name,
                  const NumberType   type,
                  const Extent      &extent,
                  const void        *data)
  {
    write_in_pieces(name,
                    type,
                    extent,
                    {std::max<std::uint64_t>(extent.n_rows, 1), 0},
                    [data](const auto, const auto) { return data; });
  }



  void
  Hdf5File::write_in_pieces(
    const std::string                                             &name,
    const NumberType                                               type,
    const Extent                                                  &extent,
    const Pieces                                                  &pieces,
    const std::function<const void *(const std::uint64_t first,
                                     const std::uint64_t n_rows)> &piece)
  {
    const Handle file_type(copy_of_type(type, extent.width, true), H5Tclose);
    const Handle space(make_space(extent.n_rows, numbers_a_row(type, extent)),
                       H5Sclose);
    const std::string group = name.substr(0, name.find('/'));
    if (group != name && H5Lexists(file, group.c_str(), H5P_DEFAULT) == 0)
      {
        const Handle of_group(creation_properties(H5P_GROUP_CREATE), H5Pclose);
        const Handle made(
          H5Gcreate2(file, group.c_str(), H5P_DEFAULT, of_group, H5P_DEFAULT),
          H5Gclose);
      }
    const Handle creation(creation_properties(H5P_DATASET_CREATE), H5Pclose);
    if (pieces.compression_level > 0 && extent.n_rows > 0)
      {
        const std::array<hsize_t, 2> chunk{
          {std::min(pieces.n_rows, extent.n_rows), extent.width}};
        H5Pset_chunk(creation, extent.width == 1 ? 1 : 2, chunk.data());
        H5Pset_shuffle(creation);
        H5Pset_deflate(creation, pieces.compression_level);
      }
    const Handle dataset(H5Dcreate2(file,
                                    name.c_str(),
                                    file_type,
                                    space,
                                    H5P_DEFAULT,
                                    creation,
                                    H5P_DEFAULT),
                         H5Dclose);
    require_on_all(dataset.is_good(), "make '" + name + "'");
    const std::uint64_t n_rounds =
      MPI::max((extent.n_local_rows + pieces.n_rows - 1) / pieces.n_rows, comm);
    bool is_good = true;
    for (std::uint64_t round = 0; round < n_rounds; ++round)
      {
        // All take part, also those that have nothing left.
        const std::uint64_t first =
          std::min(round * pieces.n_rows, extent.n_local_rows);
        Extent of_piece    = extent;
        of_piece.first_row = extent.first_row + first;
        of_piece.n_local_rows =
          std::min(pieces.n_rows, extent.n_local_rows - first);
        is_good =
          transfer(Mode::create,
                   dataset,
                   type,
                   of_piece,
                   const_cast<void *>(piece(first, of_piece.n_local_rows))) &&
          is_good;
      }
    require_on_all(is_good, "write '" + name + "'");
  }



  void
  Hdf5File::read(const std::string &name,
                 const NumberType   type,
                 const Extent      &extent,
                 void              *data) const
  {
    const Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    require_on_all(dataset.is_good(), "find '" + name + "'");
    require_on_all(transfer(Mode::read, dataset, type, extent, data),
                   "read '" + name + "'");
  }



  bool
  Hdf5File::transfer(const Mode       mode,
                     const hid_t      dataset,
                     const NumberType type,
                     const Extent    &extent,
                     void            *data)
  {
    if (extent.n_rows == 0)
      return true;
    const std::uint64_t width = numbers_a_row(type, extent);
    const Handle memory_type(copy_of_type(type, extent.width, false), H5Tclose);
    const Handle in_file(H5Dget_space(dataset), H5Sclose);
    const Handle in_memory(make_space(extent.n_local_rows, width), H5Sclose);
    const std::array<hsize_t, 2> first{{extent.first_row, 0}};
    const std::array<hsize_t, 2> size{{extent.n_local_rows, width}};
    const bool                   is_selected =
      extent.n_local_rows > 0 ?
                          H5Sselect_hyperslab(in_file,
                            H5S_SELECT_SET,
                            first.data(),
                            nullptr,
                            size.data(),
                            nullptr) >= 0 :
                          H5Sselect_none(in_file) >= 0 && H5Sselect_none(in_memory) >= 0;
    const Handle together(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
    H5Pset_dxpl_mpio(together, H5FD_MPIO_COLLECTIVE);

    // A buffer has to be given even where nothing is read or written.
    char         nothing = 0;
    void        *buffer  = extent.n_local_rows > 0 ? data : &nothing;
    const herr_t status =
      mode == Mode::create ?
        H5Dwrite(dataset, memory_type, in_memory, in_file, together, buffer) :
        H5Dread(dataset, memory_type, in_memory, in_file, together, buffer);
    return is_selected && status >= 0;
  }



  void
  Hdf5File::write_attribute(const std::string  &object,
                            const std::string  &name,
                            const std::uint64_t value)
  {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(H5Acreate_by_name(file,
                                             object.c_str(),
                                             name.c_str(),
                                             H5T_STD_U64LE,
                                             space,
                                             H5P_DEFAULT,
                                             H5P_DEFAULT,
                                             H5P_DEFAULT),
                           H5Aclose);
    require_on_all(attribute.is_good() &&
                     H5Awrite(attribute, H5T_NATIVE_UINT64, &value) >= 0,
                   "write the attribute '" + name + "' of '" + object + "'");
  }



  std::uint64_t
  Hdf5File::read_attribute(const std::string &object,
                           const std::string &name) const
  {
    const Handle  attribute(H5Aopen_by_name(file,
                                           object.c_str(),
                                           name.c_str(),
                                           H5P_DEFAULT,
                                           H5P_DEFAULT),
                           H5Aclose);
    std::uint64_t value = 0;
    require_on_all(attribute.is_good() &&
                     H5Aread(attribute, H5T_NATIVE_UINT64, &value) >= 0,
                   "find the attribute '" + name + "' of '" + object + "'");
    return value;
  }



  void
  Hdf5File::require_on_all(const bool is_good, const std::string &what) const
  {
    if (MPI::min(is_good ? 1 : 0, comm) == 0)
      throw Hdf5Error("HDF5 cannot " + what);
  }



  void
  write_hdf5_atomically(const std::string                     &path,
                        const MPI_Comm                         comm,
                        const std::function<void(Hdf5File &)> &write)
  {
    const std::string temporary = path + ".tmp";
    const bool        is_first  = MPI::this_mpi_process(comm) == 0;
    std::string       reason;
    try
      {
        {
          Hdf5File file(temporary, Hdf5File::Mode::create, comm);
          write(file);
          file.close();
        }
        if (is_first)
          replace_file(temporary, path);
      }
    catch (const Hdf5Error &error)
      {
        reason = error.what();
      }
    catch (const fs::filesystem_error &error)
      {
        reason = error.what();
      }
    if (MPI::min(reason.empty() ? 1 : 0, comm) == 1)
      return;

    std::error_code ignored;
    if (is_first)
      fs::remove(temporary, ignored);
    throw ComputationError(
      "Cannot write '" + path +
      "': " + (reason.empty() ? "another process failed" : reason) +
      ". Is there space on the disk, and may the folder be written to?");
  }
} // namespace mpm_granular::Core
