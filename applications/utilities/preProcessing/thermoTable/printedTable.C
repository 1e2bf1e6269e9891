/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "printedTable.H"
#include "IOmanip.H"
#include "OFstream.H"
#include "OSspecific.H"

#include <string>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::printedTable::printedTable(const wordList& columns)
:
    columns_(columns)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::printedTable::append(const scalarList& row)
{
    if (row.size() != columns_.size())
    {
        FatalErrorInFunction
            << row.size() << " values for the columns " << columns_
            << exit(FatalError);
    }
    rows_.append(row);
}


void Foam::dew::printedTable::print(Ostream& os) const
{
    constexpr int width = 14;
    for (const word& column : columns_)
    {
        os << setw(width) << column.c_str();
    }
    os << nl;
    for (const scalarList& row : rows_)
    {
        for (const scalar value : row)
        {
            os << setw(width) << value;
        }
        os << nl;
    }
    os << endl;
}


void Foam::dew::printedTable::write(const fileName& file) const
{
    OFstream os(file);
    os.precision(10);
    forAll(columns_, i)
    {
        os << (i ? "," : "") << columns_[i].c_str();
    }
    os << nl;
    for (const scalarList& row : rows_)
    {
        forAll(row, i)
        {
            os << (i ? "," : "") << row[i];
        }
        os << nl;
    }
    if (!os.good())
    {
        FatalErrorInFunction << "Cannot write " << file << exit(FatalError);
    }
}


void Foam::dew::printedTable::plot(const fileName& csv, const fileName& picture)
{
    const std::string script
    (
        "import csv, sys\n"
        "import matplotlib\n"
        "matplotlib.use(\"Agg\")\n"
        "import matplotlib.pyplot as plt\n"
        "rows = list(csv.reader(open(sys.argv[1])))\n"
        "data = [[float(v) for v in row] for row in rows[1:]]\n"
        "n = len(rows[0]) - 1\n"
        "fig, axes = plt.subplots(n, 1, sharex=True, squeeze=False,\n"
        "    figsize=(6, 1 + 2*n))\n"
        "for i in range(n):\n"
        "    axes[i][0].plot([r[0] for r in data], [r[i + 1] for r in data])\n"
        "    axes[i][0].set_ylabel(rows[0][i + 1])\n"
        "axes[-1][0].set_xlabel(rows[0][0])\n"
        "fig.tight_layout()\n"
        "fig.savefig(sys.argv[2])\n"
    );
    // etc/bashrc names the interpreter: another may come first in PATH
    const string python(getEnv("DEW_PYTHON"));
    const int failed = Foam::system
    (
        (python.empty() ? string("python3") : python)
      + " -c '" + script + "' '" + csv + "' '" + picture
      + "' 2> /dev/null"
    );
    if (failed)
    {
        Info<< "No picture: python3 with matplotlib is needed for it" << endl;
    }
    else
    {
        Info<< "Wrote " << picture << endl;
    }
}
