"""Results files in the hands of pandas, h5py and R."""
import csv
import sys

import h5py
import pandas

from program import Program, main, run, write

STUDY = 'study = "hands"\n[[sweep]]\nfamilies = ["cycle", "random-cubic"]\nsizes = [10, 12]\ninstances = 3\nalgorithms = ["grid"]\n'
NOTE = "ar3d: note: hands.h5 was opened for writing by another program, which cut its checksum off; its rows are those that it was written with, by their hash\n"


class InOtherHands(Program):
    def setUp(self):
        super().setUp()
        write("hands.toml", STUDY)
        self.expect("ar3d study run -q hands.toml -o hands.h5")

    def test_a_file_opened_for_writing_is_read_with_a_note(self):
        self.expect("cp hands.h5 base.h5")
        pandas.HDFStore("hands.h5").close()
        for command in ("check hands.h5", "report hands.h5 --force", "compare base.h5 hands.h5", "replay hands.h5 --all", "study resume hands.h5"):
            said = run("ar3d " + command)
            self.assertIn(said.code, (0, 7), said)  # 7: another load, and times are not compared
            self.assertEqual(said.err.count(NOTE), 1, said)
        with h5py.File("hands.h5", "a") as file:
            file["runs"][:] = file["runs"][:][::-1]
        self.refused("ar3d check hands.h5", "no checksum at its end", "pandas.HDFStore", "its rows are not those of its rows_hash; --accept-changed reads it with its rows as they are")
        for command in ("check hands.h5", "report hands.h5 --force", "compare base.h5 hands.h5", "replay hands.h5 --all"):
            said = run(f"ar3d {command} --accept-changed")
            self.assertIn(said.code, (0, 7), said)
            self.assertIn("its rows are not those of its rows_hash; its rows are read as they are; nothing says that the study made them\n", said.err)

    def test_a_file_that_another_program_holds_open_is_not_damaged(self):
        with h5py.File("hands.h5", "r+"):
            self.refused("ar3d check hands.h5", "hands.h5 is open for writing in another program: close it there")
        with pandas.HDFStore("hands.h5", "r"), h5py.File("hands.h5", "r"):
            self.expect("ar3d check hands.h5", out="PASS")

    def test_rows_as_csv_have_every_digit_of_the_seeds(self):
        self.assertEqual(self.seeds_of_csv(), self.seeds())
        self.assertGreater(max(map(int, self.seeds())), 2**63)

    def seeds(self):
        with h5py.File("hands.h5", "r") as file:
            return [str(seed) for seed in file["runs"]["seed"]]

    def seeds_of_csv(self):
        self.expect("ar3d report hands.h5 --force --rows rows.csv")
        with open("rows.csv", encoding="utf-8") as file:
            return [row["seed"] for row in csv.DictReader(file)]


class InHandsOfRLong(InOtherHands):
    def test_r_reads_seeds_from_the_rows_as_csv(self):
        self.seeds_of_csv()
        said = self.expect("""Rscript -e 'cat(read.csv("rows.csv", colClasses = c(seed = "character"))$seed, sep = "\\n")'""")
        self.assertEqual(said.out.split(), self.seeds())
        said = self.expect("""Rscript -e 'library(hdf5r); cat(format(H5File$new("hands.h5", "r")[["runs"]][]$seed), sep = "\\n")'""")
        self.assertEqual(said.out.split(), [str(min(int(seed), 2**63 - 1)) for seed in self.seeds()], "what results/SCHEMA.md says of hdf5r")


if __name__ == "__main__":
    sys.exit(main())
