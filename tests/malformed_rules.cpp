// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "malformed_rules.hpp"

#include <cmath>

namespace planescope::testing {

using namespace std::string_literals;

std::vector<Malformed> magic_rules() {
  return {
      {"nothing", "", "is empty"},
      {"other_format", "OFF\n1 2 3\n", "neither PCD nor PLY"},
      {"only_zeros", std::string(1000, '\0'), "neither PCD nor PLY"},
      {"binary_junk", "\xFF\xFE\x01junk"s, "neither PCD nor PLY"},
      {"only_magic_pcd", "# .PCD v0.7", "byte 11: the file ends inside its header"},
      {"only_magic_ply", "ply\n", "byte 4: the file ends inside its header"},
  };
}

std::vector<Malformed> pcd_header_rules() {
  std::string many = "FIELDS x y z", ones = "SIZE 4 4 4", types = "TYPE F F F";
  return {
      {"keyword_unknown", pcd("VERSION", "VERSIONS"), "line 2: \"VERSIONS\" is no keyword"},
      {"keyword_twice", pcd("HEIGHT 1", "WIDTH 2"), "line 8: WIDTH is there twice"},
      {"version", pcd("0.7\nF", "0.8\nF"), "line 2: VERSION is \"0.8\""},
      {"fields_missing", pcd("FIELDS x y z rgb label\n", ""), "no line FIELDS"},
      {"size_missing", pcd("SIZE 4 4 4 4 4\n", ""), "no line SIZE"},
      {"type_missing", pcd("TYPE F F F U U\n", ""), "no line TYPE"},
      {"width_missing", pcd("WIDTH 2\n", ""), "no line WIDTH"},
      {"height_missing", pcd("HEIGHT 1\n", ""), "no line HEIGHT"},
      {"size_short", pcd("SIZE 4 4 4 4 4", "SIZE 4 4 4 4"), "SIZE has 4 values; expected 5"},
      {"type_long", pcd("F F F U U", "F F F U U U"), "TYPE has 6 values; expected 5"},
      {"count_short", pcd("COUNT 1 1 1 1 1", "COUNT 1"), "COUNT has 1 values; expected 5"},
      {"size_3", pcd("SIZE 4", "SIZE 3"), "SIZE 3; expected I or U of 1, 2, 4 or 8"},
      {"size_0", pcd("SIZE 4", "SIZE 0"), "SIZE has \"0\""},
      {"size_negative", pcd("SIZE 4", "SIZE -4"), "SIZE has \"-4\""},
      {"type_float_2", pcd("SIZE 4", "SIZE 2"), "TYPE \"F\" with SIZE 2"},
      {"type_float_1", pcd("SIZE 4", "SIZE 1"), "TYPE \"F\" with SIZE 1"},
      {"type_unknown", pcd("TYPE F", "TYPE D"), "TYPE \"D\" with SIZE 4"},
      {"type_lower", pcd("TYPE F", "TYPE f"), "TYPE \"f\" with SIZE 4"},
      {"count_0", pcd("COUNT 1", "COUNT 0"), "COUNT has \"0\""},
      {"count_negative", pcd("COUNT 1", "COUNT -1"), "COUNT has \"-1\""},
      {"count_huge", pcd("1 1 1\nW", "1 1 4294967297\nW"), "COUNT has \"4294967297\""},
      {"record_huge",
       pcd("FIELDS x y z rgb label\nSIZE 4 4 4 4 4\nTYPE F F F U U\nCOUNT 1 1 1 1 1",
           "FIELDS x y z a b c d e f g h i j k l m n o p q\n"
           "SIZE 4 4 4 8 8 8 8 8 8 8 8 8 8 8 8 8 8 8 8 8\n"
           "TYPE F F F F F F F F F F F F F F F F F F F F\n"
           "COUNT 1 1 1 65536 65536 65536 1 1 1 1 1 1 1 1 1 1 1 1 1 1"),
       "more than 1048576 bytes"},
      {"width_sign", pcd("WIDTH 2", "WIDTH +2"), "line 7: WIDTH has \"+2\""},
      {"width_negative", pcd("WIDTH 2", "WIDTH -2"), "WIDTH has \"-2\""},
      {"width_real", pcd("WIDTH 2", "WIDTH 2.0"), "WIDTH has \"2.0\""},
      {"width_junk", pcd("WIDTH 2", "WIDTH 2x"), "WIDTH has \"2x\""},
      {"width_hex", pcd("WIDTH 2", "WIDTH 0x2"), "WIDTH has \"0x2\""},
      {"width_two", pcd("WIDTH 2", "WIDTH 2 2"), "WIDTH has 2 values"},
      {"width_none", pcd("WIDTH 2", "WIDTH"), "WIDTH has 0 values"},
      {"width_overflow", pcd("WIDTH 2", "WIDTH 4294967296"), "WIDTH has \"4294967296\""},
      {"points_overflow", pcd("POINTS 2", "POINTS 18446744073709551616"), "POINTS has"},
      {"points_negative", pcd("POINTS 2", "POINTS -1"), "POINTS has \"-1\""},
      {"points_differ", pcd("POINTS 2", "POINTS 3"), "line 10: POINTS is 3, but WIDTH x HEIGHT"},
      {"points_zero", pcd("POINTS 2", "POINTS 0"), "POINTS is 0, but WIDTH x HEIGHT is 2 x 1"},
      {"no_points",
       "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nHEIGHT 1\nPOINTS 0\nDATA ascii\n",
       "has no points"},
      {"no_counts", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nDATA ascii\n1 2 3\n", "no line POINTS"},
      {"viewpoint_short", pcd("0 0 0 1 0 0 0", "0 0 0"), "VIEWPOINT has 3 values; expected 7"},
      {"viewpoint_word", pcd("0 0 0 1", "a 0 0 1"), "VIEWPOINT has \"a\""},
      {"viewpoint_nan", pcd("0 0 0 1", "nan 0 0 1"), "VIEWPOINT has \"nan\""},
      {"data_unknown", pcd("DATA ascii", "DATA binari"), "DATA is \"binari\""},
      {"data_none", pcd("DATA ascii", "DATA"), "DATA has 0 values"},
      {"header_endless", "# .PCD\n" + std::string(70'000, '\n'), "header is longer than 65536"},
      {"line_endless", "# .PCD" + std::string(70'000, ' '), "a line is longer than 65536"},
      {"unprintable", pcd("WIDTH 2", "WIDTH \x1B[2J"), "WIDTH has \"?[2J\""},
  };
}

std::vector<Malformed> field_rules() {
  return {
      {"x_missing", pcd("FIELDS x", "FIELDS w"), "the field x is missing"},
      {"z_missing", pcd("y z rgb", "y Z rgb"), "the field z is missing"},
      {"x_twice", pcd("FIELDS x y z rgb", "FIELDS x y z x"), "x is declared twice"},
      {"label_twice", pcd("rgb label", "label label"), "label is declared twice"},
      {"x_integer", pcd("TYPE F", "TYPE I"), "the field x is 1 x signed 32-bit integers"},
      {"x_counted", pcd("COUNT 1", "COUNT 2"), "the field x is 2 x floats; expected one float"},
      {"rgb_size", pcd("SIZE 4 4 4 4", "SIZE 4 4 4 1"), "rgb is 1 x unsigned 8-bit integers"},
      {"label_counted", pcd("1\nW", "3\nW"), "label is 3 x unsigned 32-bit integers"},
      {"normal_incomplete",
       pcd("rgb label\nSIZE 4 4 4 4 4\nTYPE F F F U U", "nx ny\nSIZE 4 4 4 4 4\nTYPE F F F F F"),
       "of the fields nx, ny and nz only 2"},
      {"ply_x_missing", ply("float x", "float w"), "the field x is missing"},
      {"ply_x_twice", ply("float y", "float x"), "the field x is declared twice"},
      {"ply_x_integer", ply("float x", "int x"), "the field x is 1 x signed 32-bit integers"},
      {"ply_x_list", ply("float x", "list uchar float x"), "the field x is a list of floats"},
      {"ply_red_alone", ply("uchar green", "uchar grey"),
       "of the fields red, green and blue only 2"},
      {"ply_red_int", ply("uchar red", "int red"), "the field red is 1 x signed 32-bit integers"},
  };
}

std::vector<Malformed> pcd_ascii_rules() {
  return {
      {"word", pcd("5 6 7", "5 six 7"), "line 13: the field y is \"six\""},
      {"junk_after_number", pcd("5 6 7", "5 6x 7"), "line 13: the field y is \"6x\""},
      {"comma", pcd("5 6 7", "5 6,5 7"), "the field y is \"6,5\""},
      {"real_overflow", pcd("5 6 7", "5 1e39 7"), "the field y is \"1e39\""},
      {"label_real", pcd("0 8", "0 8.5"), "the field label is \"8.5\""},
      {"label_negative", pcd("0 8", "0 -8"), "the field label is \"-8\""},
      {"label_overflow", pcd("0 8", "0 4294967296"), "the field label is \"4294967296\""},
      {"rgb_nan", pcd("7 0 8", "7 nan 8"), "the field rgb is \"nan\""},
      {"line_short", pcd("5 6 7 0 8", "5 6 7    0"),
       "line 13: the line ends before the field label"},
      {"line_long", pcd("5 6 7 0 8", "5 6 7 0 8 9"), "line 13: the line goes on with \"9\""},
      {"line_missing", pcd("5 6 7 0 8\n", "         \n"), "the file ends after 1 of 2 points"},
      {"line_extra", pcd("8\n", "8\n\n9 9 9 9 9\n"), "line 15: there are more lines than the 2"},
      {"data_missing", pcd("1 2 3 0 4\n5 6 7 0 8\n", ""),
       "2 points of 5 numbers do not fit into 0"},
      {"points_huge",
       "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 65536\nHEIGHT 32767\nDATA ascii\n1 2 3\n",
       "2147418112 points of 3 numbers do not fit into 6 bytes"},
      {"zero_byte", pcd("5 6 7", "5 \0 7"s), "the field y is \"?\""},
      {"all_missing", pcd("1 2 3 0 4\n5 6 7 0 8", "nan 1 1 0 4\n1 inf 1 0 4"), "none of the 2"},
      {"negative_label",
       pcd("TYPE F F F U U", "TYPE F F F U I").replace(pcd().find("0 8"), 3, "0 -8"),
       "point 1: label is -8"},
  };
}

std::vector<Malformed> pcd_binary_rules() {
  const std::string label =
      "FIELDS x y z label\nSIZE 4 4 4 8\nTYPE F F F I\nWIDTH 1\nHEIGHT 1\nDATA binary\n";
  return {
      {"short_by_one", binary("1", kPoint.substr(0, 11)), "POINTS 1 needs 12 bytes from byte 73"},
      {"nothing", binary("1", ""), "byte 73: the file ends here"},
      {"huge", binary("2147483647", kPoint), "needs 25769803764 bytes"},
      {"nan", binary("1", little(NAN, 0.F, 0.F)), "none of the 1 points is finite"},
      {"label_negative", label + kPoint + little(std::int64_t{-1}), "point 0: label is -1"},
      {"label_wide", label + kPoint + little(std::int64_t{1} << 32), "label is 4294967296"},
      {"points_times_stride",
       "FIELDS x y z h\nSIZE 4 4 4 8\nTYPE F F F F\nCOUNT 1 1 1 65536\nWIDTH 4294967295\n"
       "HEIGHT 4294967295\nDATA binary\n" +
           kPoint,
       "the limit is"},
  };
}

std::vector<Malformed> pcd_compressed_rules() {
  const std::string good = "\x0B"s + kPoint;  // 12 literals
  return {
      {"no_sizes", binary("1", "\x01\x02"s, "binary_compressed"), "the compressed size needs 4"},
      {"one_size", binary("1", little(13U), "binary_compressed"), "the expanded size needs 4"},
      {"expanded_differs", compressed(13, 13, good), "the expanded size is 13, but"},
      {"expanded_huge", compressed(13, 4294967295U, good), "the expanded size is 4294967295"},
      {"stream_short", compressed(14, 12, good), "the compressed data needs 14 bytes"},
      {"compressed_huge", compressed(4294967295U, 12, good), "needs 4294967295 bytes"},
      {"compressed_none", compressed(0, 12, ""), "0 bytes of LZF cannot expand to 12"},
      {"bomb", compressed(13, 1'200'000'000, good, "100000000"), "cannot expand to 1200000000"},
      {"literal_cut", compressed(12, 12, good.substr(0, 12)), "ends inside a literal run"},
      {"copy_cut", compressed(14, 12, good + "\x20"), "byte 105: the stream ends inside a copy"},
      {"long_copy_cut", compressed(15, 12, good + "\xE0\x01"), "the stream ends inside a copy"},
      {"literal_beyond", compressed(15, 12, good + "\x00\x01"s), "expand beyond the size"},
      {"copy_beyond", compressed(15, 12, good + "\x20\x00"s), "expand beyond the size"},
      {"copy_before", compressed(4, 12, "\x00\x01\x20\x01"s), "reaches back before the first byte"},
      {"copy_of_nothing", compressed(2, 12, "\x20\x00"s), "reaches back before the first byte"},
      {"too_little", compressed(2, 12, "\x00\x01"s), "expand to 1 bytes, not the 12"},
      {"sizes_beyond_32_bits", compressed(13, 0, good, "4294967295"), "the limit is"},
  };
}

std::vector<Malformed> ply_header_rules() {
  return {
      {"magic_longer", ply("ply", "ply 1"), "line 1: the first line is not"},
      {"format_missing", ply("format ascii 1.0\n", ""), "ends without a format"},
      {"format_twice", ply("element", "format ascii 1.0\nelement"), "line 3: the format is there"},
      {"format_unknown", ply("ascii", "text"), "the format is \"text\""},
      {"format_version", ply("1.0", "2.0"), "expected its name and version 1.0"},
      {"keyword", ply("element", "elements"), "\"elements\" is no keyword of PLY"},
      {"element_count_missing", ply("vertex 2", "vertex"), "an element needs a name and a count"},
      {"element_count_sign", ply("vertex 2", "vertex -2"), "has the count \"-2\""},
      {"element_count_junk", ply("vertex 2", "vertex 2,"), "has the count \"2,\""},
      {"element_count_overflow", ply("vertex 2", "vertex 18446744073709551616"), "has the count"},
      {"property_first", ply("element vertex 2\n", ""), "before the first element"},
      {"property_type", ply("float x", "half x"), "\"half\" is no type of PLY"},
      {"property_short", ply("float x", "float"), "the property is not understood"},
      {"property_long", ply("float x", "float x x"), "the property is not understood"},
      {"list_length_real", ply("float x", "list float float x"), "the length of a list is a real"},
      {"vertex_missing", ply("vertex", "vertices"), "has 0 elements \"vertex\""},
      {"vertex_twice", ply("end_header", "element vertex 1\nend_header"), "has 2 elements"},
      {"vertex_empty", ply("vertex 2", "vertex 0"), "has no points"},
      {"end_missing", ply("end_header\n1 2 3 4 5 6\n7 8 9 0 1 2\n", ""), "inside its header"},
      {"header_endless", ply("element", std::string(70'000, '\n') + "element"),
       "longer than 65536"},
  };
}

std::vector<Malformed> ply_data_rules() {
  const std::string little_endian = "binary_little_endian";
  const auto one = [&](const std::string& before) {
    return ply_header(little_endian, before + "element vertex 1\n" + kXyz);
  };
  const auto tags = [&](const std::string& type) {
    return ply_header(little_endian,
                      "element vertex 1\nproperty list " + type + " int tags\n" + kXyz);
  };
  const std::string faces = "element face 2\nproperty list uchar int v\n";
  return {
      {"ascii_word", ply("8", "e"), "line 12: the field y is \"e\""},
      {"ascii_colour", ply("0 1 2", "256 1 2"), "the field red is \"256\""},
      {"ascii_colour_sign", ply("0 1 2", "-1 1 2"), "the field red is \"-1\""},
      {"ascii_short", ply(" 1 2\n", "    \n"), "the line ends before the field green"},
      {"ascii_long", ply("1 2\n", "1 2 3\n"), "the line goes on with \"3\""},
      {"ascii_truncated", ply("7 8 9 0 1 2\n", ""), "points of 6 numbers do not fit into 12"},
      {"ascii_extra", ply("1 2\n", "1 2\n1 2 3 4 5 6\n"), "there are more lines"},
      {"ascii_count_huge", ply("vertex 2", "vertex 2000000000"), "do not fit"},
      {"ascii_list_length",
       ply_header("ascii", "element vertex 1\nproperty list uchar int t\n" + kXyz) + "-1 1 2 3\n",
       "the length of the list t is \"-1\""},
      {"ascii_list_long",
       ply_header("ascii", "element vertex 1\nproperty list uchar int t\n" + kXyz) +
           "18446744073709551615 1 2 3\n",
       "the line ends before the field t"},
      {"ascii_before_huge",
       ply("element", "element face 18446744073709551615\nproperty int a\nelement"),
       "before the 18446744073709551615 lines of the element face"},
      {"ascii_before_missing", ply("element", "element face 2\nproperty int a\nelement"),
       "the file ends after 0 of 2 points"},
      {"truncated", one("") + kPoint.substr(0, 11), "the element vertex of 1 needs 12 bytes"},
      {"count_huge", ply_header(little_endian, "element vertex 2000000000\n" + kXyz) + kPoint,
       "needs 24000000000 bytes"},
      {"all_missing", one("") + little(1.F, NAN, 2.F), "none of the 1 points"},
      {"before_huge", one("element a 18446744073709551615\nproperty double d\n") + kPoint,
       "needs more than 2^64 bytes"},
      {"before_truncated", one("element a 2\nproperty double d\n") + kPoint, "needs 16 bytes"},
      {"face_lists_cut", one(faces) + "\x01"s + little(7) + "\xFF"s + little(1, 2),
       "the property v needs 1020 bytes"},
      {"face_list_missing", one(faces) + "\x01"s + little(7), "needs 1 bytes"},
      {"list_negative", tags("char") + "\xFF"s + kPoint, "has a negative length"},
      {"list_negative_wide", tags("int") + little(-2147483647) + kPoint, "has a negative length"},
      {"list_huge", tags("uint") + little(4294967295U) + kPoint, "needs 17179869180 bytes"},
      {"list_truncated", tags("uchar") + "\x00"s + kPoint.substr(0, 11),
       "the element vertex of 1 needs 13 bytes"},
      {"list_eats_point", tags("uchar") + "\x01"s + kPoint, "the property z needs 4 bytes"},
      {"big_endian_length",
       ply_header("binary_big_endian", "element vertex 1\nproperty list ushort int t\n" + kXyz) +
           big(std::uint16_t{2}) + kPoint,
       "the property y needs 4 bytes"},
  };
}

}  // namespace planescope::testing
